// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/presets.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/base/error.hpp"
#include "tests/faults/link_fixture.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

std::vector<AgentId> ids(std::uint32_t n) {
  std::vector<AgentId> all;
  for (const Uav& uav : row_of(n)) all.push_back(uav.id);
  return all;
}

TEST(Presets, AreThereByTheirNames) {
  std::set<std::string> names;
  for (const FaultPreset& p : fault_presets()) {
    EXPECT_TRUE(names.insert(p.name).second) << p.name;
    EXPECT_FALSE(p.meaning.empty());
    EXPECT_EQ(preset(p.name, ids(4)).name, p.name);
  }
  for (const char* name :
       {"lossy_10",      "lossy_30", "lossy_80",  "bursty",    "split_brain", "isolate_one",
        "flapping",      "one_way",  "slow_link", "delayed",   "duplicates",  "clogged",
        "crash_restart", "crash",    "pause",     "late_join", "clock_skew",  "twin",
        "malformed",     "ring",     "line",      "star",      "storm"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Presets, DoSomethingToEveryFleetThatIsLargeEnough) {
  for (const FaultPreset& p : fault_presets())
    for (const std::uint32_t n : {4u, 5u, 20u}) {
      FaultSchedule nothing;
      nothing.name = p.name;
      EXPECT_NE(preset(p.name, ids(n)), nothing) << p.name;
    }
}

TEST(Presets, LoseWhatTheirNamesSay) {
  const auto loss = [](const std::string& name) {
    return share(losses(link(preset(name, ids(3))), 100'000));
  };
  EXPECT_NEAR(loss("lossy_10"), 0.1, 0.01);
  EXPECT_NEAR(loss("lossy_30"), 0.3, 0.01);
  EXPECT_NEAR(loss("lossy_80"), 0.8, 0.01);
  EXPECT_NEAR(loss("bursty"), 0.3, 0.015);
}

TEST(Presets, SplitBrainIsTwoHalvesForTwoSeconds) {
  const FaultSchedule schedule = preset("split_brain", ids(5));
  ASSERT_EQ(schedule.partitions.size(), 1u);
  EXPECT_EQ(schedule.partitions[0].groups,
            (std::vector<std::vector<AgentId>>{{{1}, {2}}, {{3}, {4}, {5}}}));
  EXPECT_EQ(schedule.partitions[0].when, (Window{s, 3 * s}));
}

TEST(Presets, HealingInStepsJoinsTwoFirst) {
  const FaultSchedule schedule = preset("heal_in_steps", ids(3));
  const auto passes = [&](std::uint32_t to, TimeNs now_ns) {
    return link(schedule, 1, to).send(1, 100, now_ns).reason == DropReason::none;
  };
  EXPECT_FALSE(passes(2, 2 * s));
  EXPECT_FALSE(passes(3, 2 * s));
  EXPECT_TRUE(passes(2, 3 * s));
  EXPECT_FALSE(passes(3, 3 * s));
  EXPECT_TRUE(passes(3, 4 * s));
}

TEST(Presets, OneWayIsHeardByNobodyButHears) {
  const FaultSchedule schedule = preset("one_way", ids(3));
  EXPECT_EQ(link(schedule, 3, 1).send(1, 100, 2 * s).reason, DropReason::cut);
  EXPECT_EQ(link(schedule, 1, 3).send(1, 100, 2 * s).reason, DropReason::none);
}

TEST(Presets, StormIsAllOfIt) {
  const FaultSchedule schedule = preset("storm", ids(4));
  ASSERT_EQ(schedule.links.size(), 1u);
  EXPECT_EQ(schedule.links[0].burst, (Burst{0.3, 8, 0, 1}));
  EXPECT_TRUE(schedule.links[0].from.empty() && schedule.links[0].to.empty());
  ASSERT_EQ(schedule.partitions.size(), 1u);
  EXPECT_EQ(schedule.partitions[0].when.end_ns - schedule.partitions[0].when.start_ns, 2 * s);
  int killed = 0, back = 0, paused = 0;
  std::set<AgentId> agents;
  for (const AgentFault& fault : schedule.agents) {
    agents.insert(fault.agent);
    killed += fault.kind == AgentFaultKind::crash ? 1 : 0;
    back += fault.kind == AgentFaultKind::crash && fault.for_ns ? 1 : 0;
    paused += fault.kind == AgentFaultKind::pause && fault.for_ns == s ? 1 : 0;
  }
  EXPECT_EQ(killed, 2);
  EXPECT_EQ(back, 1);
  EXPECT_EQ(paused, 1);
  EXPECT_EQ(agents.size(), 3u);
  EXPECT_TRUE(schedule.until_ns);
}

std::string error_of(const std::string& name, std::uint32_t agents) {
  try {
    preset(name, ids(agents));
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Presets, RefuseFleetsThatAreTooSmallAndUnknownNames) {
  EXPECT_EQ(error_of("crash", 1), "fault preset crash: the fleet has 1 agent; it takes 2");
  EXPECT_EQ(error_of("storm", 3), "fault preset storm: the fleet has 3 agents; it takes 4");
  EXPECT_EQ(error_of("lossy_30", 1), "accepted");
  EXPECT_THAT(error_of("lossy", 4), HasSubstr("fault preset lossy: unknown; legal: lossy_10, "));
}

}  // namespace
}  // namespace arcbid
