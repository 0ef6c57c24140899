// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>

#include "core/base/error.hpp"
#include "core/io/config.hpp"

namespace arcbid {
namespace {

std::string error_of(const std::string& yaml, const std::filesystem::path& file = "demo.yaml") {
  try {
    parse_config(yaml, file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

struct Case {
  std::string name, yaml, error;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name;
}
std::string name_of(const testing::TestParamInfo<Case>& test) {
  return test.param.name;
}

class ConfigError : public testing::TestWithParam<Case> {};

TEST_P(ConfigError, SaysExactly) {
  EXPECT_EQ(error_of(GetParam().yaml), GetParam().error);
}

const std::vector<Case> one_value = {
    {"OutsideRange", "fleet:\n  speed_mps: -3",
     "demo.yaml:2:14: fleet.speed_mps: -3 is outside [0.1, 30]"},
    {"OutsideRangeInAList",
     "fleet:\n  uavs:\n  - {id: 1, home_m: [0, 0, 0]}\n  - {id: 2, home_m: [0, 9, 0], speed_mps: "
     "-3}",
     "demo.yaml:4:43: fleet.uavs[1].speed_mps: -3 is outside [0.1, 30]"},
    {"TooManyAgents", "fleet: {agents: 65}", "demo.yaml:1:17: fleet.agents: 65 is outside [1, 64]"},
    {"NotWhole", "fleet: {agents: 2.5}",
     "demo.yaml:1:17: fleet.agents: 2.5 is not an integer in [1, 64]"},
    {"NotANumber", "timeout_s: soon",
     "demo.yaml:1:12: timeout_s: soon is not a number in [1, 86400]"},
    {"NumberWithUnit", "timeout_s: 5 s",
     "demo.yaml:1:12: timeout_s: 5 s is not a number in [1, 86400]"},
    {"NumberInQuotes", "timeout_s: \"5\"",
     "demo.yaml:1:12: timeout_s: \"5\" is not a number in [1, 86400]"},
    {"NotFinite", "coverage: {spacing_m: .nan, standoff_m: .inf, safety_m: nan, seed: -inf}",
     "demo.yaml:1:23: coverage.spacing_m: .nan is not a number in [0.2, 100]\n"
     "demo.yaml:1:41: coverage.standoff_m: .inf is not a number in [0.2, 100]\n"
     "demo.yaml:1:57: coverage.safety_m: nan is not a number in [0.1, 100]\n"
     "demo.yaml:1:68: coverage.seed: -inf is not an integer in [0, 4294967295]"},
    {"TooLargeForADouble", "timeout_s: 1e999",
     "demo.yaml:1:12: timeout_s: 1e999 is outside [1, 86400]"},
    {"NoValue", "timeout_s:\nname: x",
     "demo.yaml:1:1: timeout_s: has no value; legal: a number in [1, 86400]"},
    {"ListForScalar", "timeout_s: [5]",
     "demo.yaml:1:12: timeout_s: a list is not a number in [1, 86400]"},
    {"MappingForScalar", "name: {a: b}",
     "demo.yaml:1:7: name: a mapping is not 1 to 64 printable characters without / or \\"},
    {"Choice", "auction: {policy: auctioneer}",
     "demo.yaml:1:19: auction.policy: auctioneer is not one of claims, claims-keep, cbba, "
     "cbba-rebuild, acbba"},
    {"ChoiceMisspelt", "auction: {policy: claimz}",
     "demo.yaml:1:19: auction.policy: claimz is not one of claims, claims-keep, cbba, "
     "cbba-rebuild, acbba; did you mean claims?"},
    {"YesIsNotTrue", "network: {reliable_bids: yes}",
     "demo.yaml:1:26: network.reliable_bids: yes is not one of true, false"},
    {"Endurance", "fleet: {endurance_s: 15 min}",
     "demo.yaml:1:22: fleet.endurance_s: 15 min is not a number in [1, 1000000] or unlimited"},
    {"EnduranceOfOne", "fleet:\n  uavs:\n  - {id: 1, home_m: [0, 0, 0], endurance_s: 0}",
     "demo.yaml:3:45: fleet.uavs[0].endurance_s: 0 is outside [1, 1000000]"},
    {"Payload", "fleet: {payload: radar}",
     "demo.yaml:1:18: fleet.payload: radar is not one of any, lidar, camera"},
    {"NumberOrWord", "auction: {split_m: short}",
     "demo.yaml:1:20: auction.split_m: short is not a number in [0.1, 10000] or shortest_arc"},
    {"Address", "network: {server_address: 300.1.1.1}",
     "demo.yaml:1:27: network.server_address: 300.1.1.1 is not an IPv4 address such as "
     "192.168.1.10"},
    {"NameIsNoPath", "name: ../x",
     "demo.yaml:1:7: name: ../x is not 1 to 64 printable characters without / or \\"},
    {"ShortPosition", "fleet: {uavs: [{id: 1, home_m: [0, 0]}]}",
     "demo.yaml:1:32: fleet.uavs[0].home_m: a list of 2 is not a list [x, y, z], each a number in "
     "[-1000000, 1000000]"},
    {"BadCoordinate", "fleet: {uavs: [{id: 1, home_m: [0, up, 0]}]}",
     "demo.yaml:1:36: fleet.uavs[0].home_m[1]: up is not a number in [-1000000, 1000000]"},
};
INSTANTIATE_TEST_SUITE_P(Value, ConfigError, testing::ValuesIn(one_value), name_of);

const std::vector<Case> keys = {
    {"Misspelt", "name: x\ncoverage:\n  stand_off_m: 3",
     "demo.yaml:3:3: coverage.stand_off_m: unknown key; did you mean standoff_m?"},
    {"SectionMisspelt", "fleeet: {agents: 3}",
     "demo.yaml:1:1: fleeet: unknown key; did you mean fleet?"},
    {"InTheWrongSection", "agents: 3",
     "demo.yaml:1:1: agents: unknown key; did you mean fleet.agents?"},
    {"Unknown", "tour: {colour: red}",
     "demo.yaml:1:8: tour.colour: unknown key; legal: solver, seed, epochs, iterations"},
    {"UnknownInAUav", "fleet: {uavs: [{id: 1, home: [0, 0, 0]}]}",
     "demo.yaml:1:16: fleet.uavs[0].home_m: missing; legal: a list [x, y, z], each a number in "
     "[-1000000, 1000000]\n"
     "demo.yaml:1:24: fleet.uavs[0].home: unknown key; did you mean home_m?"},
    {"Twice", "name: a\ntimeout_s: 3\nname: b",
     "demo.yaml:3:1: name: given twice; first in line 1"},
    {"SectionTwice", "tour: {seed: 1}\ntour: {epochs: 2}",
     "demo.yaml:2:1: tour: given twice; first in line 1"},
    {"NotAWord", "? [a, b]\n: 1", "demo.yaml:1:3: a key must be a word"},
    {"ScalarForSection", "coverage: 3",
     "demo.yaml:1:11: coverage: 3 is not a mapping (lines of `key: value`)"},
    {"ListForSection", "coverage: [3]",
     "demo.yaml:1:11: coverage: a list is not a mapping (lines of `key: value`)"},
    {"ListForConfig", "- name: x",
     "demo.yaml:1:1: a list is not a mapping (lines of `key: value`)"},
    {"ScalarForUavs", "fleet: {uavs: 3}",
     "demo.yaml:1:15: fleet.uavs: 3 is not a list of up to 64 UAVs"},
    {"ScalarForUav", "fleet: {uavs: [3]}",
     "demo.yaml:1:16: fleet.uavs[0]: is not a mapping such as {id: 1, home_m: [0, 0, 0]}"},
};
INSTANTIATE_TEST_SUITE_P(Key, ConfigError, testing::ValuesIn(keys), name_of);

const std::vector<Case> together = {
    {"SafetyBeyondStandoff", "coverage:\n  standoff_m: 4\n  safety_m: 5",
     "demo.yaml:3:13: coverage.safety_m: 5 is too near coverage.standoff_m, 4; at most 3.636 is "
     "legal"},
    {"StandoffBelowDefaultSafety", "coverage:\n  standoff_m: 1",
     "demo.yaml:2:15: coverage.safety_m: 2 is too near coverage.standoff_m, 1; at most 0.9091 is "
     "legal"},
    {"RangeBelowStandoff", "coverage:\n  sensor: {range_m: 3}",
     "demo.yaml:2:21: coverage.sensor.range_m: 3 does not exceed coverage.standoff_m, 4: it would "
     "see nothing"},
    {"LeastRangeBeyondStandoff", "coverage:\n  sensor: {least_range_m: 4}",
     "demo.yaml:2:27: coverage.sensor.least_range_m: 4 is not below coverage.standoff_m, 4: it "
     "would see nothing"},
    {"GimbalUpsideDown", "coverage:\n  sensor: {lowest_look_deg: 30, highest_look_deg: 20}",
     "demo.yaml:2:29: coverage.sensor.lowest_look_deg: 30 is above highest_look_deg, 20"},
    {"CameraAllRound", "coverage:\n  sensor: {kind: camera, horizontal_fov_deg: 180}",
     "demo.yaml:2:46: coverage.sensor.horizontal_fov_deg: 180 by 55 is no camera's field of view; "
     "legal: less than 180"},
    {"NotSaidAboutAValueThatIsWrongAnyway", "coverage: {standoff_m: x, safety_m: 5}",
     "demo.yaml:1:24: coverage.standoff_m: x is not a number in [0.2, 100]"},
    {"AgentsAgainstUavs", "fleet:\n  agents: 3\n  uavs: [{id: 1, home_m: [0, 0, 0]}]",
     "demo.yaml:2:11: fleet.agents: 3, but fleet.uavs lists 1; leave one of the two out"},
    {"IdsNotDistinct",
     "fleet:\n  uavs:\n  - {id: 5, home_m: [0, 0, 0]}\n  - {id: 5, home_m: [0, 3, 0]}",
     "demo.yaml:4:10: fleet.uavs[1].id: 5 is the id of fleet.uavs[0] already"},
    {"NoSuchStructure", "structure: {file: /no/such.ply}",
     "demo.yaml:1:19: structure.file: no such file: /no/such.ply"},
    {"StructureIsAFolder", "structure: {file: /}", "demo.yaml:1:19: structure.file: a folder: /"},
    {"DeckInTheGround", "structure: {parametric: {deck_height_m: 2}}",
     "demo.yaml:1:41: structure.parametric.deck_height_m: 2 is not more than the deck (1) and its "
     "girders (1.5) need"},
    {"TowersBelowTheDeck", "structure: {parametric: {kind: towers, tower_height_m: 10}}",
     "demo.yaml:1:56: structure.parametric.tower_height_m: 10 is below deck_height_m, 12"},
    {"TowersWithoutPiers", "structure: {parametric: {kind: towers, piers: 0}}",
     "demo.yaml:1:47: structure.parametric.piers: 0 is outside [1, 100] for a bridge with towers"},
    {"PiersThatOverlap", "structure: {parametric: {length_m: 20, piers: 9, pier_width_m: 3}}",
     "demo.yaml:1:64: structure.parametric.pier_width_m: 3 is more than the 2 m from pier to pier"},
    {"ArchThinnerThanItself", "structure: {parametric: {kind: arch, tower_height_m: 1}}",
     "demo.yaml:1:54: structure.parametric.tower_height_m: 1 is less than the arch is thick "
     "(pier_width_m, 2)"},
    {"LeaseOfTwoTicks", "auction: {tick_ms: 200, lease_ms: 400}",
     "demo.yaml:1:35: auction.lease_ms: 400 is less than 3 ticks of 200 ms: the living would count "
     "as dead"},
    {"RemoteServer", "network: {transport: discovery_server, server_address: 10.0.0.1}",
     "demo.yaml:1:56: network.interface_address: 127.0.0.1 cannot reach the server at 10.0.0.1; "
     "legal: this host's address on that network\n"
     "demo.yaml:1:56: network.domain: auto differs from host to host; legal with a remote server: "
     "an integer in [0, 232]"},
};
INSTANTIATE_TEST_SUITE_P(Together, ConfigError, testing::ValuesIn(together), name_of);

const std::vector<Case> syntax = {
    {"Empty", "", "demo.yaml: empty; write {} for a config of defaults only"},
    {"OnlyComments", "# nothing\n\n", "demo.yaml: empty; write {} for a config of defaults only"},
    {"EndOfListMissing", "fleet: {uavs: [1, 2}\n", "demo.yaml:1:20: not YAML: illegal flow end"},
    {"BadIndentation", "a: 1\n b: 2", "demo.yaml:2:3: not YAML: illegal map value"},
    {"NoSuchAnchor", "name: *x", "demo.yaml:1:7: not YAML: the referenced anchor is not defined"},
    {"Tab", "tour:\n\tseed: 1\n  \tepochs: 1\n \t\n",
     "demo.yaml:2:1: a tab; YAML is indented with spaces only\n"
     "demo.yaml:3:3: a tab; YAML is indented with spaces only"},
    {"TwoDocuments", "name: a\n---\nname: b\n",
     "demo.yaml:2:1: not one YAML document: another starts here"},
    {"StrayComma", "# no comma\n,\nname: a",
     "demo.yaml:2:1: not one YAML document: another starts here"},
    {"StrayCommaBehind", "name: a\n,", "demo.yaml:2:1: not YAML: end of map not found"},
    {"ZeroBytes", std::string("name: a\0", 8), "demo.yaml: has zero bytes: no text file in UTF-8"},
    {"Deep", std::string(100'000, '['), "demo.yaml:1:1: not YAML: nested too deeply"},
    {"Large", std::string(300'000, '#'), "demo.yaml: larger than 256 kB: no config"},
};
INSTANTIATE_TEST_SUITE_P(Syntax, ConfigError, testing::ValuesIn(syntax), name_of);

TEST(ConfigErrors, AllAtOnceByPosition) {
  EXPECT_EQ(
      error_of("fleet: {speed_mps: 99, agents: 0}\nnme: x\ntimeout_s: 0\ncoverage: {seed: -1}"),
      "demo.yaml:1:20: fleet.speed_mps: 99 is outside [0.1, 30]\n"
      "demo.yaml:1:32: fleet.agents: 0 is outside [1, 64]\n"
      "demo.yaml:2:1: nme: unknown key; did you mean name?\n"
      "demo.yaml:3:12: timeout_s: 0 is outside [1, 86400]\n"
      "demo.yaml:4:18: coverage.seed: -1 is outside [0, 4294967295]");
}

TEST(ConfigErrors, AMessageStaysOneShortLine) {
  const std::string error = error_of("timeout_s: \"" + std::string(5000, 'x') + "\\n\\n\"");
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 0);
  EXPECT_LT(error.size(), 200u);
}

TEST(ConfigErrors, AHostileFileDoesNotMakeEndlessMessages) {
  std::string yaml;
  for (int i = 0; i < 20'000; ++i) yaml += fmt::format("k{}: 1\n", i);
  const std::string error = error_of(yaml);
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 50);
  EXPECT_THAT(error, testing::EndsWith("\ndemo.yaml: and 19950 more"));
}

TEST(ConfigErrors, TooManyUavs) {
  std::string yaml = "fleet:\n  uavs:\n";
  for (int i = 1; i <= 65; ++i) yaml += fmt::format("  - {{id: {}, home_m: [0, {}, 0]}}\n", i, i);
  EXPECT_EQ(error_of(yaml),
            "demo.yaml:3:3: fleet.uavs: a list of 65 is not a list of up to 64 UAVs");
}

TEST(ConfigErrors, FilesThatCannotBeRead) {
  const auto error = [](const std::string& file) -> std::string {
    try {
      load_config(file);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(error("/no/such.yaml"), "/no/such.yaml: cannot be read: No such file or directory");
  EXPECT_EQ(error("/"), "/: is a folder, not a config file");
  EXPECT_EQ(error("/dev/zero"), "/dev/zero: larger than 256 kB: no config");
}

}  // namespace
}  // namespace arcbid
