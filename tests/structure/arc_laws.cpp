// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/arc_laws.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/structure/parametric.hpp"

namespace arcbid {

NearPoints::NearPoints(const std::vector<Vec3>& points, double cell_m) : cell_m_(cell_m) {
  for (const Vec3& p : points) cells_[cell(p)].push_back(p);
}

NearPoints::Cell NearPoints::cell(const Vec3& p) const {
  Cell c;
  for (int k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(std::floor(p[k] / cell_m_));
  return c;
}

double NearPoints::distance_m(const Vec3& p) const {
  const Cell c = cell(p);
  double least = cell_m_;
  for (std::int64_t x = -1; x <= 1; ++x)
    for (std::int64_t y = -1; y <= 1; ++y)
      for (std::int64_t z = -1; z <= 1; ++z) {
        const auto at = cells_.find({c[0] + x, c[1] + y, c[2] + z});
        if (at == cells_.end()) continue;
        for (const Vec3& q : at->second) least = std::min(least, (q - p).norm());
      }
  return least;
}

std::vector<Vec3> along_arcs(const std::vector<Arc>& arcs, double step_m) {
  std::vector<Vec3> points;
  for (const Arc& arc : arcs) {
    points.push_back(arc.waypoints.front().position_m);
    for (std::size_t i = 1; i < arc.waypoints.size(); ++i) {
      const Vec3 &a = arc.waypoints[i - 1].position_m, &b = arc.waypoints[i].position_m;
      const double n = std::max(1.0, std::ceil((b - a).norm() / step_m));
      for (double k = 1; k <= n; ++k) points.push_back(a + k / n * (b - a));
    }
  }
  return points;
}

void expect_arc_laws(const ArcPlan& plan, const Structure& structure,
                     const CoverageSettings& settings) {
  ASSERT_FALSE(plan.arcs.empty());
  const double floor_m = settings.ground_m.value_or(plan.low_m.z()) + settings.ground_clearance_m;
  for (std::size_t i = 0; i < plan.arcs.size(); ++i) {
    const Arc& arc = plan.arcs[i];
    ASSERT_EQ(arc.id.value, i);
    ASSERT_GE(arc.waypoints.size(), 2u);
    ASSERT_GT(length_m(arc.waypoints), 0);
    for (std::size_t w = 0; w < arc.waypoints.size(); ++w) {
      const auto& [p, look] = arc.waypoints[w];
      ASSERT_TRUE(p.allFinite() && look.allFinite());
      ASSERT_NEAR(look.norm(), 1, 1e-9);
      ASSERT_GE(p.z(), floor_m);
      if (arc.kind != ArcKind::outline) {
        ASSERT_EQ(look.z(), arc.kind == ArcKind::top_row ? -1 : 1);
      }
      if (w == 0) continue;
      const double gap_m = (p - arc.waypoints[w - 1].position_m).norm();
      ASSERT_GT(gap_m, 0);
      ASSERT_LE(gap_m, settings.spacing_m * (1 + 1e-6));
    }
  }
  const double sample_m = std::max(settings.safety_m / 10, std::sqrt(plan.surface_m2 / 1e6));
  const NearPoints surface(surface_samples(structure, sample_m, 12345), settings.safety_m);
  for (const Vec3& p : along_arcs(plan.arcs, settings.safety_m / 10))
    ASSERT_GE(surface.distance_m(p), settings.safety_m - 1e-9) << "at " << p.transpose();
}

Structure box_mesh(const Vec3& low, const Vec3& high, double yaw_rad) {
  ParametricBridge deck;
  deck.piers = 0;
  deck.girders = 0;
  deck.length_m = deck.width_m = deck.deck_height_m = deck.deck_thickness_m = 1;
  Structure box = generate(deck);  // the unit cube on the ground, centred on x = y = 0
  const Eigen::AngleAxisd turn(yaw_rad, Vec3::UnitZ());
  for (Vec3& p : box.points) {
    const Vec3 share = p + Vec3(0.5, 0.5, 0);
    p = turn * Vec3(low.array() + share.array() * (high - low).array());
  }
  return box;
}

Structure joined(const Structure& a, const Structure& b) {
  Structure both = a;
  const auto first = static_cast<std::uint32_t>(a.points.size());
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  for (const auto& [u, v, w] : b.triangles)
    both.triangles.push_back({first + u, first + v, first + w});
  return both;
}

}  // namespace arcbid
