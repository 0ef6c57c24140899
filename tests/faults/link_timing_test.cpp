// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/faults/link_fixture.hpp"

namespace arcbid {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

LinkFault delayed(const Delay& delay) {
  LinkFault fault;
  fault.delay = delay;
  return fault;
}

/// How long each of n messages took.
std::vector<double> times_ms(const LinkFault& fault, std::uint64_t n) {
  LinkModel model = link(with(fault));
  std::vector<double> times;
  for (std::uint64_t i = 1; i <= n; ++i)
    times.push_back(static_cast<double>(model.send(i, 100, 0).arrivals_ns.at(0)) / 1e6);
  return times;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  const double m = mean(values);
  double sum = 0;
  for (const double v : values) sum += (v - m) * (v - m);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(LinkTiming, FixedDelayIsThatDelay) {
  LinkModel model = link(with(delayed({Delay::Kind::fixed, 20 * ms, 0, 0})));
  EXPECT_THAT(model.send(1, 100, 3 * ms).arrivals_ns, ElementsAre(23 * ms));
  EXPECT_EQ(model.counters().delayed, 1u);
}

TEST(LinkTiming, UniformDelayFillsItsRange) {
  const auto times = times_ms(delayed({Delay::Kind::uniform, 10 * ms, 50 * ms, 0}), 20'000);
  EXPECT_NEAR(*std::min_element(times.begin(), times.end()), 10, 0.1);
  EXPECT_NEAR(*std::max_element(times.begin(), times.end()), 50, 0.1);
  EXPECT_GE(*std::min_element(times.begin(), times.end()), 10);
  EXPECT_LE(*std::max_element(times.begin(), times.end()), 50);
  EXPECT_NEAR(mean(times), 30, 0.3);
  EXPECT_NEAR(deviation(times), 40 / std::sqrt(12.0), 0.2);
}

TEST(LinkTiming, ExponentialDelayStandsOnItsFloor) {
  const auto times = times_ms(delayed({Delay::Kind::exponential, 5 * ms, 0, 40 * ms}), 20'000);
  EXPECT_GE(*std::min_element(times.begin(), times.end()), 5);
  EXPECT_NEAR(mean(times), 45, 1);
  EXPECT_NEAR(deviation(times), 40, 1.5);
}

TEST(LinkTiming, DelaysReorderAndAreNoPipe) {
  LinkModel model = link(with(delayed({Delay::Kind::uniform, 0, 100 * ms, 0})));
  int overtaken = 0;
  TimeNs last_ns = 0;
  for (std::uint64_t i = 1; i <= 1000; ++i) {
    const TimeNs sent_ns = static_cast<TimeNs>(i) * ms;
    const TimeNs arrives_ns = model.send(i, 100, sent_ns).arrivals_ns.at(0);
    EXPECT_LE(arrives_ns - sent_ns, 100 * ms);  // nobody waits for the one before
    overtaken += arrives_ns < last_ns ? 1 : 0;
    last_ns = arrives_ns;
  }
  EXPECT_GT(overtaken, 400);
}

TEST(LinkTiming, DelaysOfSeveralFaultsAddUp) {
  FaultSchedule schedule = with(delayed({Delay::Kind::fixed, 20 * ms, 0, 0}));
  schedule.links.push_back(delayed({Delay::Kind::fixed, 5 * ms, 0, 0}));
  EXPECT_THAT(link(schedule).send(1, 100, 0).arrivals_ns, ElementsAre(25 * ms));
}

TEST(LinkTiming, DuplicatesTakeTheirOwnTime) {
  LinkFault fault = delayed({Delay::Kind::uniform, 0, 100 * ms, 0});
  fault.duplicate = 0.25;
  LinkModel model = link(with(fault));
  std::uint64_t twice = 0;
  double apart_ms = 0;
  for (std::uint64_t i = 1; i <= 20'000; ++i) {
    const auto arrivals = model.send(i, 100, 0).arrivals_ns;
    ASSERT_TRUE(arrivals.size() == 1 || arrivals.size() == 2);
    if (arrivals.size() == 1) continue;
    ++twice;
    apart_ms += static_cast<double>(arrivals[1] - arrivals[0]) / 1e6;
  }
  EXPECT_NEAR(static_cast<double>(twice) / 20'000, 0.25, 0.01);
  EXPECT_NEAR(apart_ms / static_cast<double>(twice), 100 / 3.0, 1);  // of two uniform draws
  EXPECT_EQ(model.counters().duplicated, twice);
}

TEST(LinkTiming, StaleCopiesComeLater) {
  LinkFault fault = delayed({Delay::Kind::fixed, 10 * ms, 0, 0});
  fault.stale = 1;
  fault.stale_ns = 120 * s;
  EXPECT_THAT(link(with(fault)).send(1, 100, s).arrivals_ns,
              ElementsAre(s + 10 * ms, 121 * s + 10 * ms));
  fault.stale = 0.2;
  LinkModel model = link(with(fault));
  for (std::uint64_t i = 0; i < 20'000; ++i) model.send(i, 100, 0);
  EXPECT_NEAR(static_cast<double>(model.counters().duplicated) / 20'000, 0.2, 0.01);
}

LinkFault capped(double bytes_per_s, std::uint64_t queue_bytes) {
  LinkFault fault;
  fault.capacity = Capacity{bytes_per_s, queue_bytes};
  return fault;
}

TEST(LinkTiming, ACappedLinkSendsOneMessageBehindTheOther) {
  LinkModel model = link(with(capped(10'000, 0)));
  EXPECT_THAT(model.send(1, 1000, 0).arrivals_ns, ElementsAre(100 * ms));
  EXPECT_THAT(model.send(2, 500, 10 * ms).arrivals_ns, ElementsAre(150 * ms));
  EXPECT_THAT(model.send(3, 500, 400 * ms).arrivals_ns, ElementsAre(450 * ms));  // idle again
}

TEST(LinkTiming, WhatDoesNotFitIntoTheQueueIsLost) {
  LinkModel model = link(with(capped(10'000, 1500)));
  EXPECT_EQ(model.send(1, 5000, 0).reason, DropReason::none);         // an idle link queues nothing
  EXPECT_EQ(model.send(2, 1000, 450 * ms).reason, DropReason::none);  // 500 bytes left + 1000
  EXPECT_EQ(model.send(3, 1000, 450 * ms).reason, DropReason::queue);
  EXPECT_THAT(model.send(4, 1000, 550 * ms).arrivals_ns, ElementsAre(700 * ms));
}

TEST(LinkTiming, CapacityIsAPipeAndDelayComesBehindIt) {
  LinkFault fault = capped(10'000, 0);
  fault.delay = Delay{Delay::Kind::fixed, s, 0, 0};
  LinkModel model = link(with(fault));
  EXPECT_THAT(model.send(1, 1000, 0).arrivals_ns, ElementsAre(s + 100 * ms));
  EXPECT_THAT(model.send(2, 1000, 0).arrivals_ns, ElementsAre(s + 200 * ms));
}

TEST(LinkTiming, LostMessagesTakeTheirTimeOnTheLinkAndCutOnesDoNot) {
  LinkFault fault = capped(10'000, 0), loss;
  loss.loss = 1;
  loss.when = {0, 10 * ms};
  FaultSchedule schedule = with(fault);
  schedule.links.push_back(loss);
  LinkModel lossy = link(schedule);
  EXPECT_EQ(lossy.send(1, 1000, 0).reason, DropReason::loss);
  EXPECT_THAT(lossy.send(2, 1000, 10 * ms).arrivals_ns, ElementsAre(200 * ms));
  schedule.links[1].cut = true;
  LinkModel cut = link(schedule);
  EXPECT_EQ(cut.send(1, 1000, 0).reason, DropReason::cut);
  EXPECT_THAT(cut.send(2, 1000, 10 * ms).arrivals_ns, ElementsAre(110 * ms));
}

TEST(LinkTiming, AClogHoldsAllBackAndThenFloods) {
  LinkFault fault;
  fault.clog = true;
  fault.when = {s, 3 * s};
  FaultSchedule schedule = with(fault);
  LinkModel model = link(schedule);
  EXPECT_THAT(model.send(1, 100, s - 1).arrivals_ns, ElementsAre(s - 1));
  EXPECT_THAT(model.send(2, 100, s).arrivals_ns, ElementsAre(3 * s));
  EXPECT_THAT(model.send(3, 100, 2 * s).arrivals_ns, ElementsAre(3 * s));
  EXPECT_THAT(model.send(4, 100, 3 * s).arrivals_ns, ElementsAre(3 * s));
  schedule.until_ns = 2 * s;
  EXPECT_THAT(link(schedule).send(2, 100, s).arrivals_ns, ElementsAre(2 * s));
  schedule.until_ns.reset();
  schedule.links[0].when.end_ns = INT64_MAX;
  EXPECT_THAT(link(schedule).send(2, 100, s).arrivals_ns, IsEmpty());
}

TEST(LinkTiming, WhatIsUnderWayArrivesAfterTheFaultsEnd) {
  FaultSchedule schedule = with(delayed({Delay::Kind::fixed, 5 * s, 0, 0}));
  schedule.until_ns = 2 * s;
  LinkModel model = link(schedule);
  EXPECT_THAT(model.send(1, 100, s).arrivals_ns, ElementsAre(6 * s));
  EXPECT_THAT(model.send(2, 100, 2 * s).arrivals_ns, ElementsAre(2 * s));
}

}  // namespace
}  // namespace arcbid
