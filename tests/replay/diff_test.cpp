// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/diff.hpp"

#include <gmock/gmock.h>

#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::RecordedFleet;

constexpr TimeNs s = 1'000'000'000;

struct Recorded {
  Recorded(const Mission& mission, std::uint64_t seed, bool dies = false, double loss = 0) {
    RecordedFleet fleet(mission, folder.path(), seed, loss);
    EXPECT_TRUE(fleet.run(60 * s));
    if (dies) {
      fleet.kill({2});
      fleet.run_for(4 * s);
      EXPECT_TRUE(fleet.run(60 * s));
    }
    fleet.end();
    open.emplace(folder.path());
  }
  testing::TemporaryFolder folder;
  std::optional<OpenRun> open;
};

Mission mission_of(std::uint64_t seed) {
  return testing::random_mission(seed, 3, 6);
}

TEST(Diff, FindsNothingBetweenARunAndItself) {
  const Recorded one(mission_of(4), 4), again(mission_of(4), 4);
  const RunDiff found = diff(*one.open, *again.open);
  EXPECT_THAT(found.settings, IsEmpty());
  EXPECT_FALSE(found.parting);
  EXPECT_TRUE(found.same_allocation());
}

TEST(Diff, NamesWhereTwoSchedulesPartAndWhatWasHeardOtherwise) {
  const Recorded one(mission_of(4), 4), other(mission_of(4), 5, false, 0.4);
  const RunDiff found = diff(*one.open, *other.open);
  EXPECT_TRUE(found.same_allocation()) << "claims have one outcome, whatever the schedule";
  ASSERT_TRUE(found.parting);
  EXPECT_NE(found.parting->bid[0], found.parting->bid[1]);
  EXPECT_GE(found.parting->round, 1u);
  ASSERT_FALSE(found.parting->before.empty()) << "the same knowledge gives the same decision";
  EXPECT_THAT(found.parting->before[0], HasSubstr("it held "));
}

TEST(Diff, CountsTheTasksOfTheDeadAsOwnedByOthers) {
  const Recorded one(mission_of(4), 4), other(mission_of(4), 4, true);
  const RunDiff found = diff(*one.open, *other.open);
  EXPECT_FALSE(found.same_allocation());
  std::size_t had = 0;
  const auto& owners = one.open->explainer.owners();
  for (std::uint32_t j = 0; j < owners.size(); ++j)
    if (owners[j].winner == AgentId{2}) {
      ++had;
      EXPECT_THAT(found.owners, Contains(TaskId{j}));
    }
  EXPECT_GT(had, 0u);
}

TEST(Diff, NamesTheSettingsThatDiffer) {
  Mission other = mission_of(4);
  other.auction.bundle_limit = 2;
  other.id += 1;
  const Recorded a(mission_of(4), 4), b(other, 4);
  const RunDiff found = diff(*a.open, *b.open);
  EXPECT_THAT(found.settings, ::testing::ElementsAre("auction.bundle_limit: 0 and 2"));
  EXPECT_TRUE(found.same_tasks);
}

TEST(Diff, ComparesNoOwnersOfOtherTasks) {
  const Recorded a(mission_of(4), 4), b(mission_of(5), 4);
  const RunDiff found = diff(*a.open, *b.open);
  EXPECT_FALSE(found.same_tasks);
  EXPECT_FALSE(found.same_allocation());
  EXPECT_THAT(found.settings, Contains(HasSubstr("arcs: ")));
}

}  // namespace
}  // namespace arcbid
