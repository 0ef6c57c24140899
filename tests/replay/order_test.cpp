// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/order.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using testing::RecordedFleet;

constexpr TimeNs s = 1'000'000'000;

void expect_causal(const RunArchive& run) {
  const std::vector<Moment> order = causal_order(run);
  std::vector<std::size_t> next(run.lives.size(), 0);
  std::set<MessageId> said;
  std::size_t heard = 0, all = 0;
  TimeNs last_ns = INT64_MIN;
  for (const LifeLog& life : run.lives) all += life.marks().size();
  for (const Moment& moment : order) {
    EXPECT_EQ(moment.mark, next[moment.life]++) << "a life's own order";
    EXPECT_GE(moment.t_ns, last_ns);
    last_ns = moment.t_ns;
    const LifeLog& log = run.lives[moment.life];
    const Mark& mark = log.marks()[moment.mark];
    if (mark.heard) {
      ++heard;
      EXPECT_TRUE(said.contains(*mark.heard))
          << "agent " << mark.heard->sender.value << ", message " << mark.heard->sequence;
    }
    for (std::uint64_t n = 0; n < mark.sent; ++n)
      said.insert({log.agent(), log.incarnation(), mark.first_sent + n});
  }
  EXPECT_EQ(order.size(), all);
  EXPECT_GT(heard, 0u);
}

TEST(CausalOrder, HearsNothingBeforeItWasSaid) {
  const testing::TemporaryFolder folder;
  RecordedFleet fleet(testing::random_mission(3, 4, 6), folder.path(), 3);
  ASSERT_TRUE(fleet.run(60 * s));
  fleet.end();
  expect_causal(open_run(folder.path()));
}

TEST(CausalOrder, HoldsWhereHostsClocksDifferBySecondsEitherWay) {
  const testing::TemporaryFolder folder;
  RecordedFleet fleet(testing::random_mission(3, 4, 6), folder.path(), 3);
  fleet.set_clock({1}, 5 * s);
  fleet.set_clock({3}, -7 * s);
  ASSERT_TRUE(fleet.run(60 * s));
  fleet.end();
  expect_causal(open_run(folder.path()));
}

TEST(CausalOrder, IsTheOrderOfTimesWhereClocksAgree) {
  const testing::TemporaryFolder folder;
  RecordedFleet fleet(testing::random_mission(3, 4, 6), folder.path(), 3);
  ASSERT_TRUE(fleet.run(60 * s));
  fleet.end();
  const RunArchive run = open_run(folder.path());
  for (const Moment& moment : causal_order(run))
    EXPECT_EQ(moment.t_ns, run.lives[moment.life].marks()[moment.mark].t_ns);
}

}  // namespace
}  // namespace arcbid
