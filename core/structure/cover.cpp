// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/cover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/structure/triangle.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

constexpr double kMostPoints = 2e6;

double pieces(double length_m, double spacing_m) {
  return std::max(1.0, std::ceil(length_m / spacing_m));
}

/// The triangle with its longest edge first, from a to b.
Triangle longest_edge_first(Triangle t) {
  const double ab = (t.b - t.a).norm(), bc = (t.c - t.b).norm(), ca = (t.a - t.c).norm();
  if (bc >= ab && bc >= ca) return {t.b, t.c, t.a};
  if (ca >= ab && ca >= bc) return {t.c, t.a, t.b};
  return t;
}

/// Rows parallel to the longest edge; `visit(from, to, n)` for each strictly inside the triangle.
template <class Visit>
void for_each_row(const Triangle& any, double spacing_m, Visit visit) {
  const Triangle t = longest_edge_first(any);
  const double base_m = (t.b - t.a).norm();
  if (base_m == 0) return;
  const double rows = pieces(2 * area_of(t) / base_m, spacing_m);
  for (double k = 1; k < rows; ++k)
    visit(t.a + k / rows * (t.c - t.a), t.b + k / rows * (t.c - t.b),
          pieces(base_m * (1 - k / rows), spacing_m));
}

void append_between(const Vec3& from, const Vec3& to, double n, std::vector<Vec3>& out) {
  for (double j = 1; j < n; ++j) out.push_back(from + j / n * (to - from));
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Edge> edges_of(const Structure& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double points_needed(const Structure& mesh, const std::vector<Edge>& edges, double spacing_m) {
  double sum = 0;
  for (const auto& [v, w] : edges)
    sum += pieces((mesh.points[w] - mesh.points[v]).norm(), spacing_m) - 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area_m2 = area_of(triangle(mesh, t));
    sum += area_m2 / (spacing_m * spacing_m);
  }
  return sum;
}

Cover cover_mesh(const Structure& mesh, double spacing_m) {
  Cover c;
  c.of_mesh = true;
  const std::vector<Edge> edges = edges_of(mesh);
  while (points_needed(mesh, edges, spacing_m) > kMostPoints) spacing_m *= 2;

  std::vector<bool> used(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) {
      if (!used[v]) c.points.push_back(mesh.points[v]);
      used[v] = true;
    }
  for (const auto& [v, w] : edges) {
    const Vec3 &from = mesh.points[v], &to = mesh.points[w];
    append_between(from, to, pieces((to - from).norm(), spacing_m), c.points);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    c.area_m2 += area_of(triangle(mesh, t));
    for_each_row(triangle(mesh, t), spacing_m, [&](const Vec3& from, const Vec3& to, double n) {
      append_between(from, to, n, c.points);
    });
  }
  // At most one row's distance across, and along it half a gap to the row's point or, at a row's
  // end, half a gap to the end and half a gap to the edge's point: sqrt(2) spacings.
  c.radius_m = 1.5 * spacing_m;
  return c;
}

}  // namespace

double Cover::clearance_m(double safety_m) const {
  // The nearest point q of a triangle to x is either inside it, on an edge, or a vertex; the cover
  // point near q lies in the same triangle's plane, on the same edge, or is the vertex. So the two
  // offsets are at right angles. A cloud's dropped points have no such relation to the kept ones.
  return of_mesh ? std::hypot(safety_m, radius_m) : safety_m + radius_m;
}

Cover cover(const Structure& structure, double spacing_m) {
  if (structure.is_mesh()) return cover_mesh(structure, spacing_m);
  Cover c;
  c.area_m2 = static_cast<double>(one_per_voxel(structure.points, 2 * spacing_m).size()) * 4 *
              spacing_m * spacing_m;
  double voxel_m = spacing_m / 2;
  do {
    c.points = one_per_voxel(structure.points, voxel_m);
    c.radius_m = voxel_m * std::sqrt(3.0);
    voxel_m *= 2;
  } while (static_cast<double>(c.points.size()) > kMostPoints);
  return c;
}

}  // namespace arcbid
