// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>

#include "tests/faults/link_fixture.hpp"

namespace arcbid {
namespace {

using testing::ElementsAre;

LinkFault lossy(double loss) {
  LinkFault fault;
  fault.loss = loss;
  return fault;
}

LinkFault everything() {
  LinkFault fault = lossy(0.2);
  fault.burst = Burst{};
  fault.delay = Delay{Delay::Kind::exponential, 2 * ms, 0, 30 * ms};
  fault.duplicate = 0.2;
  fault.stale = 0.1;
  fault.stale_ns = s;
  return fault;
}

TEST(Link, WithoutFaultsEverythingArrivesAtOnce) {
  LinkModel model = link({});
  const Fate fate = model.send(1, 100, 5 * ms);
  EXPECT_THAT(fate.arrivals_ns, ElementsAre(5 * ms));
  EXPECT_EQ(fate.reason, DropReason::none);
  EXPECT_EQ(model.counters(), (LinkCounters{1, 0, 0, 0, 100}));
}

TEST(Link, LosesTheStatedShareIndependently) {
  for (const double loss : {0.1, 0.3, 0.8}) {
    const std::vector<bool> lost = losses(link(with(lossy(loss))), 200'000);
    EXPECT_NEAR(share(lost), loss, 0.005);
    EXPECT_NEAR(mean_run(lost), 1 / (1 - loss), 0.03 / (1 - loss));
  }
  EXPECT_EQ(share(losses(link(with(lossy(1))), 1000)), 1);
  EXPECT_EQ(share(losses(link(with(lossy(0))), 1000)), 0);
}

TEST(Link, LargeMessagesAreLostMoreOften) {
  LinkFault fault = lossy(0.1);
  fault.loss_per_kb = 0.2;
  EXPECT_NEAR(share(losses(link(with(fault)), 100'000, 2000)), 0.5, 0.01);
  EXPECT_NEAR(share(losses(link(with(fault)), 100'000, 500)), 0.2, 0.01);
  EXPECT_EQ(share(losses(link(with(fault)), 1000, 100'000)), 1);
}

TEST(Link, TheSameMessagesMeetTheSameFate) {
  LinkModel a = link(with(everything())), b = link(with(everything()));
  for (std::uint64_t i = 1; i < 5000; ++i) {
    const Fate fate = a.send(i, 100, 7 * ms), again = b.send(i, 100, 7 * ms);
    EXPECT_EQ(fate.arrivals_ns, again.arrivals_ns);
    EXPECT_EQ(fate.reason, again.reason);
  }
  EXPECT_EQ(a.counters(), b.counters());
}

TEST(Link, ChanceKnowsNoTimeAndNoOrder) {
  LinkModel forward = link(with(everything())), backward = link(with(everything()));
  std::vector<Fate> fates;
  for (std::uint64_t i = 0; i < 2000; ++i) fates.push_back(forward.send(i, 100, 0));
  for (std::uint64_t i = 2000; i-- > 0;) {
    Fate fate = backward.send(i, 100, 40 * s);
    for (TimeNs& t : fate.arrivals_ns) t -= 40 * s;
    EXPECT_EQ(fate.arrivals_ns, fates[i].arrivals_ns);
    EXPECT_EQ(fate.reason, fates[i].reason);
  }
}

TEST(Link, SeedsAndLinksHaveChancesOfTheirOwn) {
  const auto fates = losses(link(with(lossy(0.5))), 10'000);
  const auto agreement = [&](const std::vector<bool>& other) {
    std::size_t equal = 0;
    for (std::size_t i = 0; i < fates.size(); ++i) equal += fates[i] == other[i] ? 1 : 0;
    return static_cast<double>(equal) / static_cast<double>(fates.size());
  };
  EXPECT_EQ(agreement(losses(link(with(lossy(0.5))), 10'000)), 1);
  EXPECT_NEAR(agreement(losses(link(with(lossy(0.5), 2)), 10'000)), 0.5, 0.03);
  EXPECT_NEAR(agreement(losses(link(with(lossy(0.5)), 2, 1), 10'000)), 0.5, 0.03);
  EXPECT_NEAR(agreement(losses(link(with(lossy(0.5)), 1, 3), 10'000)), 0.5, 0.03);
}

TEST(Link, TwoFaultsOfOneKindDrawApart) {
  FaultSchedule twice = with(lossy(0.5));
  twice.links.push_back(lossy(0.5));
  EXPECT_NEAR(share(losses(link(twice), 100'000)), 0.75, 0.01);
}

TEST(Link, AFaultConcernsTheLinksItNames) {
  LinkFault fault = lossy(1);
  fault.from = {{1}};
  fault.to = {{2}, {3}};
  const auto loses = [&](std::uint32_t from, std::uint32_t to) {
    return share(losses(link(with(fault), from, to), 10)) == 1;
  };
  EXPECT_TRUE(loses(1, 2));
  EXPECT_TRUE(loses(1, 3));
  EXPECT_FALSE(loses(2, 1));
  EXPECT_FALSE(loses(2, 3));
  fault.both_ways = true;
  EXPECT_TRUE(loses(2, 1));
  EXPECT_TRUE(loses(3, 1));
  EXPECT_FALSE(loses(2, 3));
  fault.to = {};
  fault.both_ways = false;
  EXPECT_TRUE(loses(1, 3));
  EXPECT_FALSE(loses(3, 1));
}

DropReason reason_at(const FaultSchedule& schedule, TimeNs now_ns) {
  return link(schedule).send(1, 100, now_ns).reason;
}

TEST(Link, FaultsHoldInTheirWindow) {
  LinkFault fault = lossy(1);
  fault.when = {2 * s, 4 * s};
  FaultSchedule schedule = with(fault);
  EXPECT_EQ(reason_at(schedule, 2 * s - 1), DropReason::none);
  EXPECT_EQ(reason_at(schedule, 2 * s), DropReason::loss);
  EXPECT_EQ(reason_at(schedule, 4 * s - 1), DropReason::loss);
  EXPECT_EQ(reason_at(schedule, 4 * s), DropReason::none);
  schedule.until_ns = 3 * s;
  EXPECT_EQ(reason_at(schedule, 3 * s - 1), DropReason::loss);
  EXPECT_EQ(reason_at(schedule, 3 * s), DropReason::none);
}

TEST(Link, ACutFlapsFromItsStart) {
  LinkFault fault;
  fault.cut = true;
  fault.when = {s, 10 * s};
  EXPECT_EQ(reason_at(with(fault), 2 * s), DropReason::cut);
  fault.flap_ns = s / 2;
  EXPECT_EQ(reason_at(with(fault), s), DropReason::cut);
  EXPECT_EQ(reason_at(with(fault), s + s / 2), DropReason::none);
  EXPECT_EQ(reason_at(with(fault), 2 * s), DropReason::cut);
  EXPECT_EQ(reason_at(with(fault), 10 * s), DropReason::none);
}

TEST(Link, PartitionsSeverGroupsAndWhoeverIsInNone) {
  FaultSchedule schedule;
  schedule.partitions = {{{{{1}, {2}}, {{4}}}, {s, 3 * s}, 0}};
  const auto passes = [&](std::uint32_t from, std::uint32_t to, TimeNs now_ns) {
    LinkModel model(schedule, row_of(5), {from}, {to});
    return model.send(1, 100, now_ns).reason == DropReason::none;
  };
  EXPECT_TRUE(passes(1, 2, s));
  EXPECT_FALSE(passes(2, 4, s));
  EXPECT_FALSE(passes(4, 3, s));
  EXPECT_FALSE(passes(3, 5, s));
  EXPECT_TRUE(passes(2, 4, s - 1));
  EXPECT_TRUE(passes(2, 4, 3 * s));
  schedule.partitions[0].flap_ns = s / 2;
  EXPECT_FALSE(passes(2, 4, s));
  EXPECT_TRUE(passes(2, 4, s + s / 2));
  schedule.until_ns = s;
  EXPECT_TRUE(passes(2, 4, s));
}

TEST(Link, ReachFallsEvenlyWithDistance) {
  LinkFault fault;
  fault.reach = Reach{10, 30};
  EXPECT_EQ(share(losses(link(with(fault), 1, 2), 1000)), 0);               // 10 m
  EXPECT_NEAR(share(losses(link(with(fault), 1, 3), 100'000)), 0.5, 0.01);  // 20 m
  fault.reach = Reach{5, 10};
  EXPECT_EQ(reason_at(with(fault), 0), DropReason::reach);
  fault.reach = Reach{10, 10};
  EXPECT_EQ(reason_at(with(fault), 0), DropReason::none);
}

TEST(Link, ObstaclesBlockTheLineOfSight) {
  LinkFault fault;
  fault.obstacles = {{Vec3(24, -1, -1), Vec3(26, 1, 1)}};  // between agents 2 and 3
  EXPECT_EQ(share(losses(link(with(fault), 1, 2), 10)), 0);
  EXPECT_EQ(share(losses(link(with(fault), 2, 3), 10)), 1);
  EXPECT_EQ(share(losses(link(with(fault), 3, 1), 10)), 1);
}

TEST(Link, ALinkThatDoesNotExistCarriesNothing) {
  FaultSchedule schedule;
  schedule.topology.kind = TopologyKind::line;
  LinkModel model = link(schedule, 1, 3);
  EXPECT_EQ(model.send(1, 100, 0).reason, DropReason::no_link);
  EXPECT_EQ(model.counters(), (LinkCounters{1, 1, 0, 0, 100}));
}

TEST(Link, ANewLifeMeetsTheFateOfItsNumbers) {
  LinkModel model = link(with(everything()));
  std::vector<DropReason> first, second;
  for (std::uint64_t i = 1; i <= 300; ++i) first.push_back(model.send(i, 100, 0).reason);
  for (std::uint64_t i = 1; i <= 300; ++i) second.push_back(model.send(i, 100, 9 * s).reason);
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace arcbid
