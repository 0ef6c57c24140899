// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/arc.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

namespace arcbid {
namespace {

using Polyline = std::vector<Waypoint>;

bool same(const Waypoint& a, const Waypoint& b) {
  return a.position_m == b.position_m && a.look == b.look;
}
bool same(const Polyline& a, const Polyline& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Waypoint& p, const Waypoint& q) { return same(p, q); });
}

/// An L: 3 m along x, then 4 m along y; the look turns from -x to -y to -z.
Polyline corner() {
  return {{Vec3(0, 0, 0), -Vec3::UnitX()},
          {Vec3(3, 0, 0), -Vec3::UnitY()},
          {Vec3(3, 4, 0), -Vec3::UnitZ()}};
}

TEST(Length, IsTheSumOfTheSegments) {
  EXPECT_EQ(length_m(corner()), 7);
  EXPECT_EQ(length_m(reversed(corner())), 7);
}

TEST(Part, OfOneSegment) {
  const Polyline p = part(corner(), 1, 2);
  ASSERT_EQ(p.size(), 2u);
  EXPECT_TRUE(p[0].position_m.isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(p[1].position_m.isApprox(Vec3(2, 0, 0)));
}

TEST(Part, AcrossACornerKeepsTheCorner) {
  const Polyline p = part(corner(), 2, 5);
  ASSERT_EQ(p.size(), 3u);
  EXPECT_TRUE(p[0].position_m.isApprox(Vec3(2, 0, 0)));
  EXPECT_TRUE(same(p[1], corner()[1]));
  EXPECT_TRUE(p[2].position_m.isApprox(Vec3(3, 2, 0)));
}

TEST(Part, CutsAtWaypointsAreTheWaypoints) {
  EXPECT_TRUE(same(part(corner(), 0, 7), corner()));
  EXPECT_TRUE(same(part(corner(), 0, 3), {corner()[0], corner()[1]}));
  EXPECT_TRUE(same(part(corner(), 3, 7), {corner()[1], corner()[2]}));
}

TEST(Part, LooksAreInterpolatedAndUnit) {
  const Waypoint cut = part(corner(), 1.5, 7)[0];
  EXPECT_TRUE(cut.look.isApprox(Vec3(-1, -1, 0).normalized()));
  const Polyline opposite = {{Vec3(0, 0, 0), Vec3::UnitY()}, {Vec3(2, 0, 0), -Vec3::UnitY()}};
  EXPECT_EQ(part(opposite, 1, 2)[0].look.norm(), 1);
}

TEST(PartDeathTest, OfNothingIsOurOwnBug) {
  EXPECT_DEATH(part(corner(), 2, 2), "internal check failed: part\\(\\) of a proper interval");
  EXPECT_DEATH(part(corner(), -1, 2), "internal check failed");
}

double coordinate() {
  return *rc::gen::inRange(-1'000'000, 1'000'001) / 7919.0;
}

/// 2 to 9 distinct waypoints with unit looks.
Polyline any_polyline() {
  Polyline polyline;
  const int count = *rc::gen::inRange(2, 10);
  while (static_cast<int>(polyline.size()) < count) {
    const Vec3 position(coordinate() + static_cast<double>(polyline.size()), coordinate(),
                        coordinate());
    const Vec3 look(coordinate() + 200, coordinate(), coordinate());
    if (polyline.empty() || (polyline.back().position_m - position).norm() > 1e-3)
      polyline.push_back({position, look.normalized()});
  }
  return polyline;
}

/// Distances 0 = d_0 < d_1 < ... = length, at least a ten-thousandth of it apart.
std::vector<double> any_cuts(double length) {
  std::set<int> ticks = *rc::gen::container<std::set<int>>(rc::gen::inRange(1, 10'000));
  std::vector<double> cuts = {0};
  for (const int tick : ticks) cuts.push_back(length * tick / 10'000);
  cuts.push_back(length);
  return cuts;
}

TEST(PartProperty, PartsTileThePolyline) {
  EXPECT_TRUE(rc::check("end to end, bitwise; every waypoint once; lengths add up", [] {
    const Polyline whole = any_polyline();
    const double length = length_m(whole);
    const std::vector<double> cuts = any_cuts(length);
    Polyline joined;
    double sum_m = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const Polyline piece = part(whole, cuts[i - 1], cuts[i]);
      RC_ASSERT(piece.size() >= 2u);
      RC_ASSERT(std::abs(length_m(piece) - (cuts[i] - cuts[i - 1])) < 1e-9 * length);
      sum_m += length_m(piece);
      if (!joined.empty()) {
        RC_ASSERT(same(joined.back(), piece.front()));
        joined.pop_back();
      }
      joined.insert(joined.end(), piece.begin(), piece.end());
    }
    RC_ASSERT(std::abs(sum_m - length) < 1e-9 * length);
    RC_ASSERT(same(joined.front(), whole.front()));
    RC_ASSERT(same(joined.back(), whole.back()));
    std::size_t found = 0;
    for (const Waypoint& w : joined)
      if (found < whole.size() && same(w, whole[found])) ++found;
    RC_ASSERT(found == whole.size());
    RC_ASSERT(joined.size() <= whole.size() + cuts.size() - 2);
  }));
}

TEST(PartProperty, EqualDistancesGiveEqualPoints) {
  EXPECT_TRUE(rc::check("whatever the other end", [] {
    const Polyline whole = any_polyline();
    const double length = length_m(whole);
    const int at = *rc::gen::inRange(2, 9'999);
    const double cut_m = length * at / 10'000;
    const double from_m = length * *rc::gen::inRange(0, at) / 10'000;
    const double to_m = length * *rc::gen::inRange(at + 1, 10'001) / 10'000;
    const Waypoint end = part(whole, from_m, cut_m).back();
    RC_ASSERT(same(end, part(whole, cut_m, to_m).front()));
    RC_ASSERT(same(end, part(whole, 0, cut_m).back()));
    RC_ASSERT(std::abs(end.look.norm() - 1) < 1e-12);
  }));
}

TEST(Reversed, TwiceIsTheSame) {
  EXPECT_TRUE(same(reversed(reversed(corner())), corner()));
  EXPECT_TRUE(same(reversed(corner())[0], corner()[2]));
}

TEST(ArcDigest, EveryBitCounts) {
  const std::vector<Arc> arcs = {{ArcId{0}, ArcKind::outline, corner()},
                                 {ArcId{1}, ArcKind::top_row, reversed(corner())}};
  std::set<std::uint64_t> digests = {digest(arcs)};
  EXPECT_EQ(digest(std::vector<Arc>(arcs)), *digests.begin());
  std::size_t changes = 0;
  const auto change = [&](auto edit) {
    std::vector<Arc> changed = arcs;
    edit(changed);
    digests.insert(digest(changed));
    ++changes;
  };
  change([](auto& a) { a[0].id.value = 7; });
  change([](auto& a) { a[0].kind = ArcKind::underside_row; });
  change([](auto& a) { a.pop_back(); });
  change([](auto& a) { a[1].waypoints.pop_back(); });
  change([](auto& a) { std::swap(a[0], a[1]); });
  change([](auto& a) { a.clear(); });
  for (std::size_t w = 0; w < 3; ++w)
    for (int axis = 0; axis < 3; ++axis) {
      change([&](auto& a) {
        double& x = a[1].waypoints[w].position_m[axis];
        x = std::nextafter(x, 1e9);
      });
      change([&](auto& a) {
        double& x = a[1].waypoints[w].look[axis];
        x = std::nextafter(x, 1e9);
      });
    }
  EXPECT_EQ(digests.size(), 1 + changes);
}

TEST(StraightTransit, IsTheDistanceAndTheTwoEnds) {
  const StraightTransit transit;
  EXPECT_EQ(transit.length_m(Vec3(0, 0, 0), Vec3(3, 4, 0)), 5);
  EXPECT_EQ(transit.way(Vec3(0, 0, 0), Vec3(3, 4, 0)),
            (std::vector<Vec3>{Vec3(0, 0, 0), Vec3(3, 4, 0)}));
}

TEST(ArcKindName, IsDistinct) {
  const std::set<std::string_view> names = {name(ArcKind::outline), name(ArcKind::top_row),
                                            name(ArcKind::underside_row)};
  EXPECT_EQ(names.size(), 3u);
}

}  // namespace
}  // namespace arcbid
