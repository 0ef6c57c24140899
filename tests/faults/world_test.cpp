// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/faults/line_of_sight.hpp"
#include "tests/faults/link_fixture.hpp"

namespace arcbid {
namespace {

/// "12 13": the links there are among agents 1 to n.
std::string links(const Topology& topology, std::uint32_t n) {
  std::string text;
  for (std::uint32_t a = 1; a <= n; ++a)
    for (std::uint32_t b = 1; b <= n; ++b)
      if (linked(topology, row_of(n), {a}, {b}))
        text += fmt::format("{}{}{}", text.empty() ? "" : " ", a, b);
  return text;
}

TEST(Topology, HasTheLinksItsNameSays) {
  EXPECT_EQ(links({TopologyKind::complete, 0}, 3), "12 13 21 23 31 32");
  EXPECT_EQ(links({TopologyKind::ring, 0}, 4), "12 14 21 23 32 34 41 43");
  EXPECT_EQ(links({TopologyKind::ring, 0}, 2), "12 21");
  EXPECT_EQ(links({TopologyKind::line, 0}, 4), "12 21 23 32 34 43");
  EXPECT_EQ(links({TopologyKind::star, 0}, 4), "12 13 14 21 31 41");
  EXPECT_EQ(links({TopologyKind::geometric, 10}, 3), "12 21 23 32");
  EXPECT_EQ(links({TopologyKind::geometric, 9.9}, 3), "");
}

TEST(Topology, GoesByPositionNotById) {
  const std::vector<Uav> fleet = {
      {{3}, Vec3::Zero(), 1}, {{7}, Vec3::Zero(), 1}, {{40}, Vec3::Zero(), 1}};
  EXPECT_TRUE(linked({TopologyKind::line, 0}, fleet, {3}, {7}));
  EXPECT_FALSE(linked({TopologyKind::line, 0}, fleet, {3}, {40}));
}

TEST(LineOfSight, MeetsABoxItCrossesTouchesOrStartsIn) {
  const Obstacle box{Vec3(1, 1, 1), Vec3(3, 2, 4)};
  EXPECT_TRUE(meets(box, Vec3(0, 0, 0), Vec3(4, 3, 5)));          // through
  EXPECT_TRUE(meets(box, Vec3(4, 3, 5), Vec3(0, 0, 0)));          // and back
  EXPECT_TRUE(meets(box, Vec3(0, 1.5, 2), Vec3(9, 1.5, 2)));      // along an axis
  EXPECT_TRUE(meets(box, Vec3(2, 1.5, 2), Vec3(2, 1.5, 3)));      // inside
  EXPECT_TRUE(meets(box, Vec3(2, 1.5, 2), Vec3(2, 1.5, 2)));      // a point inside
  EXPECT_TRUE(meets(box, Vec3(0, 1, 1), Vec3(9, 1, 1)));          // along an edge
  EXPECT_FALSE(meets(box, Vec3(0, 0.9, 1), Vec3(9, 0.9, 1)));     // beside it
  EXPECT_FALSE(meets(box, Vec3(0, 1.5, 2), Vec3(0.9, 1.5, 2)));   // ends before
  EXPECT_FALSE(meets(box, Vec3(3.1, 1.5, 2), Vec3(9, 1.5, 2)));   // starts behind
  EXPECT_FALSE(meets(box, Vec3(0, 1.5, 0), Vec3(1.5, -0.5, 6)));  // passes a corner
  EXPECT_FALSE(meets(box, Vec3(0, 0, 5), Vec3(9, 9, 5)));         // above
}

AgentFault clock(std::uint32_t agent, TimeNs at_ns, TimeNs offset_ns, double drift) {
  AgentFault fault;
  fault.agent = {agent};
  fault.kind = AgentFaultKind::clock;
  fault.at_ns = at_ns;
  fault.offset_ns = offset_ns;
  fault.drift = drift;
  return fault;
}

TEST(Clock, ShowsOffsetsDriftAndSteps) {
  FaultSchedule schedule;
  schedule.agents = {clock(1, 0, 30 * s, 0), clock(1, 5 * s, -10 * s, 0.01), clock(2, 0, s, 0)};
  EXPECT_EQ(clock_of(schedule, {3}, 7 * s), 7 * s);
  EXPECT_EQ(clock_of(schedule, {2}, 7 * s), 8 * s);
  EXPECT_EQ(clock_of(schedule, {1}, 5 * s - 1), 35 * s - 1);
  EXPECT_EQ(clock_of(schedule, {1}, 5 * s), 25 * s);
  EXPECT_EQ(clock_of(schedule, {1}, 7 * s), 27 * s + 20 * ms);
  schedule.agents[1].for_ns = 2 * s;
  EXPECT_EQ(clock_of(schedule, {1}, 7 * s - 1), 27 * s + 20 * ms - 1);
  EXPECT_EQ(clock_of(schedule, {1}, 7 * s), 37 * s);
  schedule.agents[1].kind = AgentFaultKind::pause;
  EXPECT_EQ(clock_of(schedule, {1}, 6 * s), 36 * s);
}

}  // namespace
}  // namespace arcbid
