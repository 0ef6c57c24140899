// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/distances.hpp"

#include <algorithm>
#include <cmath>

#include "sim/certificate/embree.hpp"

namespace arcbid::certificate {

struct Distances::Tree {
  explicit Tree(const Structure& s)
      : structure(s), middle(middle_of(s)), margin_m(1e-4 + 4 * float_error_m(s, middle)) {
    if (s.is_mesh())
      embree.build(RTC_GEOMETRY_TYPE_TRIANGLE, RTC_SCENE_FLAG_ROBUST,
                   [this](RTCGeometry geometry) { fill_triangles(geometry, structure, middle); });
    else if (!s.points.empty())
      embree.build(RTC_GEOMETRY_TYPE_USER, RTC_SCENE_FLAG_ROBUST,
                   [this](RTCGeometry geometry) { fill_points(geometry); });
  }

  Triangle triangle(std::uint32_t number) const {
    const auto& corners = structure.triangles[number];
    return {structure.points[corners[0]], structure.points[corners[1]],
            structure.points[corners[2]]};
  }

  void fill_points(RTCGeometry geometry) {
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(structure.points.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(
        geometry,
        [](const RTCBoundsFunctionArguments* of) {
          const Tree& tree = *static_cast<const Tree*>(of->geometryUserPtr);
          const Eigen::Vector3f at =
              (tree.structure.points[of->primID] - tree.middle).cast<float>();
          *of->bounds_o = {at.x(), at.y(), at.z(), 0, at.x(), at.y(), at.z(), 0};
        },
        nullptr);
  }

  /// Calls `take(number)` for all that may be within `*reach_m` of the point; `take` may lower it.
  template <class Take>
  void visit(const Vec3& point, double* reach_m, const Take& take) const {
    struct Visit {
      const Tree& tree;
      double* reach_m;
      const Take& take;
    } visit{*this, reach_m, take};
    const Eigen::Vector3f at = (point - middle).cast<float>();
    RTCPointQuery query{at.x(), at.y(), at.z(), 0, padded(*reach_m)};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(
        embree.scene(), &query, &context,
        [](RTCPointQueryFunctionArguments* found) {
          const Visit& v = *static_cast<Visit*>(found->userPtr);
          const double before_m = *v.reach_m;
          v.take(found->primID);
          if (*v.reach_m >= before_m) return false;
          found->query->radius = v.tree.padded(*v.reach_m);
          return true;
        },
        &visit);
  }

  /// Embree may not leave out what is nearer: its boxes and our point are rounded to float.
  float padded(double reach_m) const { return static_cast<float>(reach_m * (1 + 1e-5) + margin_m); }

  const Structure& structure;
  const Vec3 middle;
  const double margin_m;
  EmbreeScene embree;
};

Distances::Distances(const Structure& structure) : tree_(std::make_unique<Tree>(structure)) {}
Distances::~Distances() = default;

double Distances::from(const Vec3& point, double most_m) const {
  const Tree& tree = *tree_;
  double best_m = most_m;
  tree.visit(point, &best_m, [&](std::uint32_t number) {
    const double d = tree.structure.is_mesh() ? distance_m(point, tree.triangle(number))
                                              : (point - tree.structure.points[number]).norm();
    best_m = std::min(best_m, d);
  });
  return best_m;
}

Approach Distances::from(const Vec3& leg_from, const Vec3& leg_to, double most_m) const {
  const Tree& tree = *tree_;
  Approach best{most_m, 0};
  // Long legs in pieces: what a ball around a piece holds has to be looked at one by one.
  const auto pieces =
      static_cast<int>(std::clamp(std::ceil((leg_to - leg_from).norm() / 4.0), 1.0, 100000.0));
  for (int piece = 0; piece < pieces; ++piece) {
    const double begin = static_cast<double>(piece) / pieces,
                 share = 1.0 / static_cast<double>(pieces);
    const Vec3 a = leg_from + begin * (leg_to - leg_from), b = a + share * (leg_to - leg_from);
    const double half_m = 0.5 * (b - a).norm();
    double reach_m = best.distance_m + half_m;
    tree.visit(0.5 * (a + b), &reach_m, [&](std::uint32_t number) {
      const Approach one = tree.structure.is_mesh() ? approach(a, b, tree.triangle(number))
                                                    : approach(a, b, tree.structure.points[number]);
      if (one.distance_m >= best.distance_m) return;
      best = {one.distance_m, begin + share * one.along};
      reach_m = best.distance_m + half_m;
    });
  }
  return best;
}

std::vector<std::uint32_t> Distances::near(const Vec3& point, double most_m) const {
  std::vector<std::uint32_t> found;
  double reach_m = most_m;
  tree_->visit(point, &reach_m, [&found](std::uint32_t number) { found.push_back(number); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace arcbid::certificate
