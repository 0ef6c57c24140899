// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/fault_script.hpp"

#include <gmock/gmock.h>

#include "sim/launcher/monitor.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;

constexpr TimeNs second = 1'000'000'000;

AgentFault fault(std::uint32_t agent, AgentFaultKind kind, double at_s,
                 std::optional<double> for_s = {}) {
  AgentFault out;
  out.agent = {agent};
  out.kind = kind;
  out.at_ns = static_cast<TimeNs>(at_s * 1e9);
  if (for_s) out.for_ns = static_cast<TimeNs>(*for_s * 1e9);
  return out;
}

std::vector<ProcessFault> all(FaultScript script) {
  std::vector<ProcessFault> out;
  for (ProcessFault f; script.next(INT64_MAX, f);) out.push_back(f);
  return out;
}

TEST(FaultScript, IsInTheOrderOfTime) {
  FaultSchedule schedule;
  schedule.agents = {fault(3, AgentFaultKind::pause, 2, 1), fault(1, AgentFaultKind::crash, 1, 4),
                     fault(2, AgentFaultKind::twin, 1.5, 1), fault(0, AgentFaultKind::crash, 0.5)};
  using A = ProcessAction;
  EXPECT_THAT(
      all(FaultScript(schedule)),
      ElementsAre(
          ProcessFault{second / 2, {0}, A::kill}, ProcessFault{second, {1}, A::kill},
          ProcessFault{3 * second / 2, {2}, A::start_twin}, ProcessFault{2 * second, {3}, A::pause},
          ProcessFault{5 * second / 2, {2}, A::kill_twin}, ProcessFault{3 * second, {3}, A::resume},
          ProcessFault{5 * second, {1}, A::start}));
}

TEST(FaultScript, GivesAFaultWhenItIsDueAndOnce) {
  FaultSchedule schedule;
  schedule.agents = {fault(1, AgentFaultKind::crash, 1, 1)};
  FaultScript script(schedule);
  ProcessFault next;
  EXPECT_FALSE(script.next(second - 1, next));
  EXPECT_TRUE(script.returns({1}));
  ASSERT_TRUE(script.next(second, next));
  EXPECT_EQ(next.action, ProcessAction::kill);
  EXPECT_FALSE(script.next(second, next));
  ASSERT_TRUE(script.next(2 * second, next));
  EXPECT_EQ(next.action, ProcessAction::start);
  EXPECT_FALSE(script.returns({1}));
}

TEST(FaultScript, KnowsWhoComesLate) {
  FaultSchedule schedule;
  schedule.agents = {fault(2, AgentFaultKind::late, 0, 3), fault(1, AgentFaultKind::crash, 1, 1)};
  const FaultScript script(schedule);
  EXPECT_TRUE(script.comes_late({2}));
  EXPECT_FALSE(script.comes_late({1}));
  EXPECT_FALSE(script.comes_late({3}));
}

TEST(FaultScript, IsOverWhenADeathMustHaveBeenNoticed) {
  FaultSchedule schedule;
  EXPECT_EQ(FaultScript(schedule).over_ns(second, 1), 0);
  schedule.agents = {fault(2, AgentFaultKind::crash, 3)};
  EXPECT_GT(FaultScript(schedule).over_ns(2 * second, 1), 5 * second);
}

TEST(FaultScript, IsOverWhenAllThatIsMalformedWasSaid) {
  FaultSchedule schedule;
  schedule.agents = {fault(2, AgentFaultKind::malformed, 3)};
  schedule.agents[0].count = 100;
  EXPECT_GT(FaultScript(schedule).over_ns(0, second / 10), 13 * second);
  EXPECT_LT(FaultScript(schedule).over_ns(60 * second, second / 10), 15 * second);
  schedule.agents[0].malformation = Malformation::over_bid;
  EXPECT_GT(FaultScript(schedule).over_ns(60 * second, 0), 63 * second) << "its death is noticed";
}

nlohmann::json links_event(int from, int sent, int dropped) {
  return {{"event", "links"},
          {"links",
           {{{"from", from},
             {"sent", sent},
             {"dropped", dropped},
             {"delayed", 1},
             {"duplicated", 0}}}}};
}

TEST(MonitoredLinks, AddUpOverTheLivesOfAReceiver) {
  Monitor monitor(std::vector<AgentId>{{1}, {2}});
  monitor.heard(2, links_event(1, 10, 3));
  monitor.heard(2, links_event(1, 20, 5));
  EXPECT_EQ((monitor.links().at({1, 2}).sent), 20u);
  monitor.starts(2);
  monitor.heard(2, links_event(1, 4, 1));
  EXPECT_EQ((monitor.links().at({1, 2}).sent), 24u);
  EXPECT_EQ((monitor.links().at({1, 2}).dropped), 6u);
  EXPECT_EQ((monitor.links().at({1, 2}).delayed), 2u);
}

TEST(MonitoredAgents, BeginAnewWithAProcess) {
  Monitor monitor(std::vector<AgentId>{{1}});
  monitor.heard(1, {{"event", "up"}});
  monitor.ended(1);
  monitor.starts(1);
  EXPECT_FALSE(monitor.agents().at(1).gone);
  EXPECT_FALSE(monitor.agents().at(1).up);
}

}  // namespace
}  // namespace arcbid::testing
