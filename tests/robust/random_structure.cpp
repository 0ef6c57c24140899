// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/random_structure.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/structure/parametric.hpp"
#include "tests/robust/chance.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {

namespace {

Structure bridge(Chance& chance) {
  ParametricBridge b;
  b.kind = static_cast<BridgeKind>(chance.below(3));
  b.length_m = chance.real(6, 30);
  b.width_m = chance.real(2, 10);
  b.deck_height_m = chance.real(4, 12);
  b.deck_thickness_m = chance.real(0.1, 1);
  b.piers = static_cast<std::uint32_t>(1 + chance.below(2));
  b.pier_width_m = chance.real(0.3, 1.5);
  b.girders = static_cast<std::uint32_t>(chance.below(4));
  b.girder_depth_m = chance.real(0.3, 2);
  b.tower_height_m = b.deck_height_m + chance.real(1, 8);
  return generate(b);
}

/// Apart or through each other.
Structure boxes(Chance& chance) {
  Structure all;
  for (int n = 1 + chance.below(4); n > 0; --n) {
    const Vec3 low = chance.within(10);
    Vec3 size;
    size.x() = chance.real(0.1, 12);
    size.y() = chance.real(0.1, 6);
    size.z() = std::max(0.0, chance.real(-2, 8));  // now and then flat
    all = joined(all, box_mesh(low, low + size, chance.real(0, 3)));
  }
  return all;
}

Structure bar(const Vec3& from, const Vec3& to, double thick_m) {
  const double half = thick_m / 2;
  Structure s = box_mesh({0, -half, -half}, {(to - from).norm(), half, half});
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), to - from);
  for (Vec3& p : s.points) p = from + turn * p;
  return s;
}

/// Two sides of bars with struts between them: much of it can be seen from one side only.
Structure truss(Chance& chance) {
  const double bay = chance.real(1.5, 5), width = chance.real(1.5, 6), high = chance.real(1, 5);
  const double thick = chance.real(0.05, 0.4), level = chance.real(0, 6);
  Structure all;
  for (int k = 0, bays = 1 + chance.below(3); k < bays; ++k)
    for (const double y : {0.0, width}) {
      const Vec3 foot(k * bay, y, level), top(k * bay, y, level + high), along(bay, 0, 0);
      for (const Structure& s : {bar(foot, foot + along, thick), bar(top, top + along, thick),
                                 bar(foot, top, thick), bar(foot, top + along, thick)})
        all = joined(all, s);
      if (y == 0) all = joined(all, bar(top, top + Vec3(0, width, 0), thick));
    }
  return all;
}

Structure plates(Chance& chance) {
  Structure all;
  for (int n = 1 + chance.below(5); n > 0; --n) {
    const Vec3 at = chance.within(8), u = chance.within(5), v = chance.within(5);
    all = joined(all, {{at, at + u, at + u + v, at + v}, {{0, 1, 2}, {0, 2, 3}}});
  }
  return all;
}

/// One to a few points: on a spot, on a line, on a plane, or a triangle without area.
Structure spots(Chance& chance) {
  const int count = 1 + chance.below(6);
  const Vec3 at = chance.within(8), u = chance.within(8), v = chance.within(8);
  const int dimensions = chance.below(3);
  Structure s;
  for (int k = 0; k < count; ++k)
    s.points.push_back(at + (dimensions > 0 ? k : 0) * u +
                       (dimensions > 1 ? chance.real(0, 1) : 0.0) * v);
  if (count > 2 && chance.below(2) == 0) s.triangles.push_back({0, 1, 2});
  return s;
}

void damage_mesh(Structure& s, const Recipe& r, Chance& chance) {
  const std::size_t count = s.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const auto [a, b, c] = s.triangles[t];
    if (r.flipped && t % 2 == 0) std::swap(s.triangles[t][1], s.triangles[t][2]);
    if (r.doubled) s.triangles.push_back({c, b, a});
    if (r.degenerate && t % 3 == 0) s.triangles.push_back({a, b, b});
    if (r.degenerate && t % 5 == 0) s.triangles.push_back({c, c, c});
    if (r.non_manifold && t % 7 == 0) {
      s.points.push_back(s.points[a] + chance.within(1));
      s.triangles.push_back({a, b, static_cast<std::uint32_t>(s.points.size() - 1)});
    }
  }
}

void damage_cloud(Structure& s, const Recipe& r, Chance& chance) {
  if (r.holed)
    for (int n = 3; n > 0; --n) {
      const Vec3 middle =
          s.points[static_cast<std::size_t>(chance.below(1 << 30)) % s.points.size()];
      const double radius = chance.real(0.3, 2);
      if (s.points.size() > 100)
        std::erase_if(s.points, [&](const Vec3& p) { return (p - middle).norm() < radius; });
      if (s.points.empty()) s.points.push_back(middle);
    }
  if (r.noisy)
    for (Vec3& p : s.points)
      for (double& x : p) x += chance.normal(0.05);
  if (r.outliers)
    for (int n = 3; n > 0; --n) s.points.push_back(chance.within(30));
}

double extent_m(const Structure& s) {
  Vec3 low = s.points.front(), high = low;
  for (const Vec3& p : s.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

void add_ground(Structure& s) {
  constexpr double half = 20;
  double z = s.points.front().z();
  for (const Vec3& p : s.points) z = std::min(z, p.z());
  if (s.is_mesh()) {
    s = joined(s, {{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}},
                   {{0, 1, 2}, {0, 2, 3}}});
    return;
  }
  for (double x = -half; x <= half; ++x)
    for (double y = -half; y <= half; ++y) s.points.emplace_back(x, y, z);
}

}  // namespace

Structure make(const Recipe& r) {
  Chance chance(r.seed);
  static constexpr Structure (*kMakers[])(Chance&) = {bridge, boxes, truss, plates, spots};
  Structure s = kMakers[static_cast<int>(r.make)](chance);
  if (r.cloud && r.make != Make::spots)
    s = {surface_samples(s, chance.real(0.15, 0.4), r.seed), {}};
  if (s.is_mesh())
    damage_mesh(s, r, chance);
  else if (s.points.size() > 6)
    damage_cloud(s, r, chance);
  if (r.ground) add_ground(s);
  const double extent = extent_m(s);
  for (Vec3& p : s.points) {
    if (r.tiny && extent > 0) p *= 0.1 / extent;
    if (r.far) p += Vec3(1e5, -1e5, 300);
  }
  if (r.stray && s.is_mesh()) s.points.emplace_back(-9e5, 9e5, 9e5);
  return s;
}

Recipe random_recipe(std::uint32_t seed) {
  Chance chance(seed);
  Recipe r;
  r.make = static_cast<Make>(seed % 5);
  r.seed = seed;
  r.cloud = chance.once_in(2);
  r.tiny = chance.once_in(10);
  for (bool* flaw : {&r.far, &r.ground, &r.non_manifold, &r.doubled, &r.flipped, &r.degenerate,
                     &r.stray, &r.noisy, &r.holed, &r.outliers})
    *flaw = chance.once_in(4);
  return r;
}

std::ostream& operator<<(std::ostream& out, const Recipe& r) {
  constexpr const char* kMakes[] = {"bridge", "boxes", "truss", "plates", "spots"};
  out << kMakes[static_cast<int>(r.make)] << ' ' << r.seed;
  for (const auto& [set, word] : {std::pair{r.cloud, " cloud"},
                                  {r.tiny, " tiny"},
                                  {r.far, " far"},
                                  {r.ground, " ground"},
                                  {r.non_manifold, " non-manifold"},
                                  {r.doubled, " doubled"},
                                  {r.flipped, " flipped"},
                                  {r.degenerate, " degenerate"},
                                  {r.stray, " stray"},
                                  {r.noisy, " noisy"},
                                  {r.holed, " holed"},
                                  {r.outliers, " outliers"}})
    if (set) out << word;
  return out;
}

}  // namespace arcbid
