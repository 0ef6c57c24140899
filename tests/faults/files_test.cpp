// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr TimeNs ms = 1'000'000, s = 1000 * ms;
const std::filesystem::path source_dir = ARCBID_SOURCE_DIR;
const std::vector<AgentId> four = {{1}, {2}, {3}, {4}};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string error_of(const std::string& name, const std::vector<AgentId>& fleet = four) {
  try {
    load_faults(name, fleet);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(FaultFile, EmptyMappingsMeanNoFaults) {
  EXPECT_EQ(parse_faults("{}", "f.yaml"), FaultSchedule{});
  EXPECT_EQ(parse_faults("links:\nagents:\n", "f.yaml"), FaultSchedule{});
  EXPECT_EQ(parse_faults("# a comment\n---\nseed: 1\n", "f.yaml"), FaultSchedule{});
  EXPECT_EQ(to_yaml(FaultSchedule{}), "{}\n");
}

TEST(FaultFile, EveryKeyOfALinkReachesItsField) {
  const FaultSchedule schedule = parse_faults(R"(
name: all
seed: 7
until_s: 20
topology: {kind: geometric, radius_m: 12.5}
links:
  - {from: [1, 2], to: 3, both_ways: true, from_s: 1, to_s: 2.5, loss: 0.3, loss_per_kb: 0.01,
     burst: {mean_loss: 0.2, mean_length: 5, good_loss: 0.1, bad_loss: 0.9},
     reach: {full_m: 10, none_m: 30}, obstacles: [{least_m: [0, 1, 2], most_m: [3, 4, 5]}],
     cut: true, flap_s: 0.25, delay: {kind: uniform, least_ms: 5, most_ms: 50}, duplicate: 0.1,
     stale: 0.05, stale_s: 120, capacity: {bytes_per_s: 1000, queue_bytes: 500}, clog: true}
  - {from: any, delay: {kind: exponential, least_ms: 5, mean_ms: 40}}
)",
                                              "f.yaml");
  LinkFault all;
  all.from = {{1}, {2}};
  all.to = {{3}};
  all.both_ways = true;
  all.when = {s, 2 * s + s / 2};
  all.loss = 0.3;
  all.loss_per_kb = 0.01;
  all.burst = Burst{0.2, 5, 0.1, 0.9};
  all.reach = Reach{10, 30};
  all.obstacles = {{Vec3(0, 1, 2), Vec3(3, 4, 5)}};
  all.cut = true;
  all.flap_ns = s / 4;
  all.delay = Delay{Delay::Kind::uniform, 5 * ms, 50 * ms, 0};
  all.duplicate = 0.1;
  all.stale = 0.05;
  all.stale_ns = 120 * s;
  all.capacity = Capacity{1000, 500};
  all.clog = true;
  LinkFault second;
  second.delay = Delay{Delay::Kind::exponential, 5 * ms, 0, 40 * ms};
  FaultSchedule expected;
  expected.name = "all";
  expected.seed = 7;
  expected.until_ns = 20 * s;
  expected.topology = {TopologyKind::geometric, 12.5};
  expected.links = {all, second};
  EXPECT_EQ(schedule, expected);
}

TEST(FaultFile, PartitionsAndAgentsReachTheirFields) {
  const FaultSchedule schedule = parse_faults(R"(
partitions:
  - {groups: [[1, 2], [3]], from_s: 1, to_s: 3, flap_s: 0.5}
agents:
  - {agent: 3, crash: {at_s: 2, back_after_s: 1.5}}
  - {agent: coordinator, pause: {at_s: 1}}
  - {agent: 1, late: {by_s: 3}}
  - {agent: 2, clock: {at_s: 1, for_s: 4, offset_s: -5, drift: 0.001}}
  - {agent: 2, twin: {at_s: 1, for_s: 2}}
  - {agent: 2, malformed: {at_s: 6, what: over_bid, count: 9}}
)",
                                              "f.yaml");
  FaultSchedule expected;
  expected.partitions = {{{{{1}, {2}}, {{3}}}, {s, 3 * s}, s / 2}};
  using K = AgentFaultKind;
  AgentFault clock{.agent = {2}, .kind = K::clock, .at_ns = s, .for_ns = 4 * s};
  clock.offset_ns = -5 * s;
  clock.drift = 0.001;
  AgentFault malformed{.agent = {2}, .kind = K::malformed, .at_ns = 6 * s, .for_ns = {}};
  malformed.malformation = Malformation::over_bid;
  malformed.count = 9;
  expected.agents = {{.agent = {3}, .kind = K::crash, .at_ns = 2 * s, .for_ns = s + s / 2},
                     {.agent = {0}, .kind = K::pause, .at_ns = s, .for_ns = {}},
                     {.agent = {1}, .kind = K::late, .for_ns = 3 * s},
                     clock,
                     {.agent = {2}, .kind = K::twin, .at_ns = s, .for_ns = 2 * s},
                     malformed};
  EXPECT_EQ(schedule, expected);
}

TEST(FaultFile, EveryPresetReadsBackFromItsYaml) {
  for (const FaultPreset& p : fault_presets()) {
    const FaultSchedule schedule = load_faults(p.name, four);
    EXPECT_EQ(schedule, preset(p.name, four));
    EXPECT_EQ(parse_faults(to_yaml(schedule), "preset.yaml", four), schedule) << to_yaml(schedule);
  }
}

TEST(FaultFile, PrintsForPeople) {
  EXPECT_EQ(to_yaml(load_faults("split_brain", four)),
            "name: \"split_brain\"\n"
            "partitions:\n"
            "  - {groups: [[1, 2], [3, 4]], from_s: 1, to_s: 3}\n");
}

TEST(FaultFile, AllFilesThatComeWithTheProgramAreLegal) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir / "configs/faults")) {
    EXPECT_NO_THROW(load_faults(entry.path().string(), four)) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 1);
}

TEST(FaultFile, WhatIsNeitherFileNorPresetIsToldThePresets) {
  EXPECT_THAT(error_of("lossy_3"),
              testing::StartsWith("faults: lossy_3 is neither a file nor a preset; did you mean "
                                  "lossy_30?; presets: lossy_10, lossy_30, "));
  EXPECT_THAT(error_of("lossy_3"), Not(HasSubstr("\n")));
  EXPECT_EQ(error_of("/no/such.yaml"), "/no/such.yaml: cannot be read: No such file or directory");
  EXPECT_EQ(error_of("none.yaml"), "none.yaml: cannot be read: No such file or directory");
  EXPECT_EQ(error_of("/"), "/: is a folder, not a fault file");
}

TEST(FaultFile, AgentsMustBeInTheFleet) {
  const std::string file = (source_dir / "configs/faults/example.yaml").string();
  EXPECT_THAT(error_of(file, {{1}, {2}, {3}}), HasSubstr("4 is not in the fleet; legal: 1, 2, 3"));
  EXPECT_EQ(error_of("storm", {{1}, {2}, {3}}),
            "fault preset storm: the fleet has 3 agents; it takes 4");
}

TEST(FaultDocs, HaveEveryKeyAndPreset) {
  const std::string docs = text_of(source_dir / "docs/FAULTS.md");
  EXPECT_THAT(docs, HasSubstr(fault_reference()));
  EXPECT_THAT(docs, HasSubstr(fault_preset_reference()));
}

TEST(FaultDocs, ShowTheExampleThatComesAlong) {
  const std::string example = text_of(source_dir / "configs/faults/example.yaml");
  EXPECT_THAT(text_of(source_dir / "docs/FAULTS.md"),
              HasSubstr(example.substr(example.find("name:"))));
}

}  // namespace
}  // namespace arcbid
