// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"

namespace arcbid {
namespace {

struct Case {
  std::string name, yaml, error;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name;
}
std::string name_of(const testing::TestParamInfo<Case>& test) {
  return test.param.name;
}

class FaultError : public testing::TestWithParam<Case> {};

TEST_P(FaultError, SaysExactly) {
  std::string error = "accepted";
  try {
    parse_faults(GetParam().yaml, "f.yaml", {{1}, {2}, {3}, {4}});
  } catch (const InputError& e) {
    error = e.what();
  }
  EXPECT_EQ(error, GetParam().error);
}

const std::vector<Case> text = {
    {"Empty", "", "f.yaml: empty; write {} for a fault file of defaults"},
    {"NotYaml", "links: [", "f.yaml:1:1: not YAML: end of sequence flow not found"},
    {"Tab", "links:\n\t- loss: 1", "f.yaml:2:1: a tab; YAML is indented with spaces only"},
    {"TwoDocuments", "seed: 1\n---\nseed: 2",
     "f.yaml:2:1: not one YAML document: another starts here"},
    {"ZeroByte", std::string("a\0b", 3), "f.yaml: has zero bytes: no text file in UTF-8"},
    {"List", "[1]", "f.yaml:1:1: a list is not a mapping (lines of `key: value`)"},
};
INSTANTIATE_TEST_SUITE_P(Text, FaultError, testing::ValuesIn(text), name_of);

const std::vector<Case> keys = {
    {"Misspelt", "links: [{los: 0.3}]",
     "f.yaml:1:9: links[0]: does nothing; legal: at least one of loss, loss_per_kb, burst, reach, "
     "obstacles, cut, delay, duplicate, stale, capacity, clog\n"
     "f.yaml:1:15: links[0].los: unknown key; did you mean loss?"},
    {"LacksUnit", "until: 3", "f.yaml:1:8: until: unknown key; did you mean until_s?"},
    {"UnknownBelow", "links: [{burst: {colour: 1}}]",
     "f.yaml:1:26: links[0].burst.colour: unknown key; legal: mean_loss, mean_length, good_loss, "
     "bad_loss"},
    {"Twice", "seed: 1\nseed: 2", "f.yaml:2:1: seed: given twice; first in line 1"},
    {"OutsideRange", "links:\n  - loss: 2", "f.yaml:2:11: links[0].loss: 2 is outside [0, 1]"},
    {"NotSaidToDoNothingAsWell", "links: [{duplicate: 2}]",
     "f.yaml:1:21: links[0].duplicate: 2 is outside [0, 1]"},
    {"Missing", "agents: [{agent: 1, crash: {}}]",
     "f.yaml:1:28: agents[0].crash.at_s: missing; legal: a number in [0, 86400]"},
    {"ListMeant", "links: 3", "f.yaml:1:8: links: 3 is not a list of up to 1000 faults of links"},
    {"MappingMeant", "links: [3]",
     "f.yaml:1:9: links[0]: 3 is not a mapping (lines of `key: value`)"},
    {"AnId", "links: [{from: two, cut: true}]",
     "f.yaml:1:16: links[0].from: two is not an integer in [1, 65535]"},
    {"NoIds", "links: [{from: [], cut: true}]",
     "f.yaml:1:16: links[0].from: an empty list; write any for all agents"},
    {"Coordinator", "agents: [{agent: coordinater, crash: {at_s: 1}}]",
     "f.yaml:1:18: agents[0].agent: coordinater is not an agent's id or coordinator; did you mean "
     "coordinator?"},
};
INSTANTIATE_TEST_SUITE_P(Key, FaultError, testing::ValuesIn(keys), name_of);

const std::vector<Case> links = {
    {"EmptyWindow", "links: [{cut: true, from_s: 3, to_s: 3}]",
     "f.yaml:1:38: links[0].to_s: 3 is not after from_s, 3"},
    {"AfterTheEnd", "until_s: 2\nlinks: [{cut: true, from_s: 3}]",
     "f.yaml:2:29: links[0].from_s: 3 is not before until_s, 2"},
    {"DoesNothing", "links: [{from: 1}]",
     "f.yaml:1:9: links[0]: does nothing; legal: at least one of loss, loss_per_kb, burst, reach, "
     "obstacles, cut, delay, duplicate, stale, capacity, clog"},
    {"NotInTheFleet", "links: [{from: [1, 9], cut: true}]",
     "f.yaml:1:20: links[0].from[1]: 9 is not in the fleet; legal: 1, 2, 3, 4"},
    {"ListedTwice", "links: [{to: [1, 2, 1], cut: true}]",
     "f.yaml:1:21: links[0].to[2]: 1 is listed twice"},
    {"BurstTooShort", "links: [{burst: {mean_loss: 0.9, mean_length: 2}}]",
     "f.yaml:1:47: links[0].burst.mean_length: 2 is too short for a mean loss of 0.9; at least 9 "
     "is legal"},
    {"BurstMeanAboveBad", "links: [{burst: {mean_loss: 0.9, bad_loss: 0.8}}]",
     "f.yaml:1:29: links[0].burst.mean_loss: 0.9 is outside [good_loss, bad_loss), [0, 0.8)"},
    {"BurstMeanBelowGood", "links: [{burst: {mean_loss: 0.1, good_loss: 0.2}}]",
     "f.yaml:1:29: links[0].burst.mean_loss: 0.1 is outside [good_loss, bad_loss), [0.2, 1)"},
    {"Uniform", "links: [{delay: {kind: uniform, least_ms: 5, most_ms: 2}}]",
     "f.yaml:1:55: links[0].delay.most_ms: 2 is less than least_ms, 5"},
    {"MostWithFixed", "links: [{delay: {least_ms: 5, most_ms: 9}}]",
     "f.yaml:1:40: links[0].delay.most_ms: means nothing; legal with kind uniform only"},
    {"MeanWithUniform", "links: [{delay: {kind: uniform, most_ms: 5, mean_ms: 9}}]",
     "f.yaml:1:54: links[0].delay.mean_ms: means nothing; legal with kind exponential only"},
    {"ExponentialWithoutMean", "links: [{delay: {kind: exponential}}]",
     "f.yaml:1:24: links[0].delay.mean_ms: missing; legal with kind exponential: more than 0"},
    {"Reach", "links: [{reach: {full_m: 9, none_m: 3}}]",
     "f.yaml:1:37: links[0].reach.none_m: 3 is less than full_m, 9"},
    {"Box", "links: [{obstacles: [{least_m: [0, 5, 0], most_m: [1, 2, 1]}]}]",
     "f.yaml:1:51: links[0].obstacles[0].most_m: is less than least_m along an axis"},
    {"FlapWithoutCut", "links: [{loss: 1, flap_s: 2}]",
     "f.yaml:1:27: links[0].flap_s: means nothing without cut: true"},
    {"StaleWithoutTime", "links: [{stale: 0.5}]",
     "f.yaml:1:17: links[0].stale_s: missing; legal: stale and stale_s together, each more than "
     "0"},
    {"TimeWithoutStale", "links: [{loss: 1, stale_s: 5}]",
     "f.yaml:1:28: links[0].stale: missing; legal: stale and stale_s together, each more than 0"},
    {"ClogForEver", "links: [{clog: true}]",
     "f.yaml:1:16: links[0].clog: has no end; give to_s or until_s"},
    {"NoBandwidth", "links: [{capacity: {queue_bytes: 5}}]",
     "f.yaml:1:20: links[0].capacity.bytes_per_s: missing; legal: a number in [1, 1000000000000]"},
};
INSTANTIATE_TEST_SUITE_P(Link, FaultError, testing::ValuesIn(links), name_of);

const std::vector<Case> others = {
    {"InTwoGroups", "partitions: [{groups: [[1, 2], [2, 3]]}]",
     "f.yaml:1:33: partitions[0].groups[1][0]: 2 is in a group already"},
    {"EmptyGroup", "partitions: [{groups: [[1], []]}]",
     "f.yaml:1:29: partitions[0].groups[1]: an empty group; leave it out"},
    {"NoGroup", "partitions: [{groups: []}]",
     "f.yaml:1:23: partitions[0].groups: no group; legal: one or more"},
    {"StrangerInAGroup", "partitions: [{groups: [[1, 7]]}]",
     "f.yaml:1:28: partitions[0].groups[0][1]: 7 is not in the fleet; legal: 1, 2, 3, 4"},
    {"PartitionEmptyWindow", "partitions: [{groups: [[1]], from_s: 2, to_s: 1}]",
     "f.yaml:1:47: partitions[0].to_s: 1 is not after from_s, 2"},
    {"GeometricWithoutRadius", "topology: {kind: geometric}",
     "f.yaml:1:18: topology.radius_m: missing; legal with geometric: more than 0"},
    {"RadiusOfARing", "topology: {kind: ring, radius_m: 3}",
     "f.yaml:1:34: topology.radius_m: 3 means nothing; legal with geometric only"},
    {"NoFault", "agents: [{agent: 1}]",
     "f.yaml:1:10: agents[0]: says no fault; legal: one of crash, pause, late, clock, twin, "
     "malformed"},
    {"TwoFaults", "agents: [{agent: 1, late: {by_s: 1}, crash: {at_s: 2}}]",
     "f.yaml:1:45: agents[0].crash: besides late; one fault an entry"},
    {"CoordinatorLate", "agents: [{agent: coordinator, late: {by_s: 1}}]",
     "f.yaml:1:18: agents[0].agent: coordinator can only crash or pause"},
    {"Stranger", "agents: [{agent: 5, late: {by_s: 1}}]",
     "f.yaml:1:18: agents[0].agent: 5 is not in the fleet; legal: 1, 2, 3, 4"},
    {"ClockIsRight", "agents: [{agent: 1, clock: {at_s: 1}}]",
     "f.yaml:1:28: agents[0].clock.offset_s: does nothing; legal: offset_s or drift"},
    {"DeadAlready",
     "agents:\n  - {agent: 1, crash: {at_s: 2}}\n  - {agent: 1, pause: {at_s: 5, for_s: 1}}",
     "f.yaml:3:5: agents[1]: overlaps with agents[0]: that agent is down"},
    {"NotYetThere", "agents:\n  - {agent: 1, late: {by_s: 2}}\n  - {agent: 1, crash: {at_s: 1.5}}",
     "f.yaml:3:5: agents[1]: overlaps with agents[0]: that agent is down"},
    {"TwiceButApart",
     "agents:\n  - {agent: 1, crash: {at_s: 2, back_after_s: 1}}\n  - {agent: 1, crash: {at_s: 3}}",
     "accepted"},
    {"Malformation", "agents: [{agent: 1, malformed: {at_s: 1, what: nan}}]",
     "f.yaml:1:48: agents[0].malformed.what: nan is not one of nan_bid, unknown_task, "
     "unknown_agent, wrong_mission, wrong_tasks, over_bid, replay; did you mean nan_bid?"},
};
INSTANTIATE_TEST_SUITE_P(Other, FaultError, testing::ValuesIn(others), name_of);

}  // namespace
}  // namespace arcbid
