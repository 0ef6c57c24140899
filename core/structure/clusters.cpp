// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>

#include "core/structure/hull.hpp"
#include "core/structure/voxels.hpp"

namespace arcbid {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

Point to_point(const Vec3& p) {
  return {p.x(), p.y()};
}

/// A cluster's number for each of the points. Single linkage at `gap_m` is what a Euclidean minimum
/// spanning tree without its edges longer than gap_m leaves together, and the tree is a part of the
/// Delaunay triangulation. Chosen over PCL's EuclideanClusterExtraction: the same clusters, but
/// n log n for any gap, where radius searches visit every pair closer than the gap.
std::vector<std::uint32_t> single_linkage(const std::vector<Vec3>& points, const PointCells& cells,
                                          double gap_m) {
  std::vector<std::pair<Point, std::uint32_t>> sites;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    sites.emplace_back(to_point(points[cells.order[cells.starts[c]]]), c);
  const Delaunay delaunay(sites.begin(), sites.end());

  std::vector<std::uint32_t> rank(cells.size()), parent(cells.size());
  boost::disjoint_sets sets(rank.data(), parent.data());
  for (std::uint32_t c = 0; c < cells.size(); ++c) sets.make_set(c);
  for (const auto& [face, k] : delaunay.finite_edges()) {
    const auto a = face->vertex(Delaunay::cw(k)), b = face->vertex(Delaunay::ccw(k));
    if (CGAL::squared_distance(a->point(), b->point()) <= gap_m * gap_m)
      sets.union_set(a->info(), b->info());
  }
  std::vector<std::uint32_t> cluster(cells.size());
  for (std::uint32_t c = 0; c < cells.size(); ++c) cluster[c] = sets.find_set(c);
  return cluster;
}

Ring hull_of(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& members) {
  std::vector<Point> flat, hull;
  flat.reserve(members.size());
  for (const std::uint32_t i : members) flat.push_back(to_point(points[i]));
  CGAL::convex_hull_2(flat.begin(), flat.end(), std::back_inserter(hull));
  Ring ring;
  for (const Point& p : hull) ring.emplace_back(p.x(), p.y());
  return ring;
}

}  // namespace

std::vector<Hull> clustered_hulls(const std::vector<Vec3>& points, double gap_m, double cell_m) {
  if (points.empty()) return {};
  const PointCells cells = group(points, cell_m, CellShape::column);
  const std::vector<std::uint32_t> cluster = single_linkage(points, cells, gap_m);

  std::map<std::uint32_t, Hull> hulls;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    auto& members = hulls[cluster[c]].members;
    members.insert(members.end(), cells.order.begin() + cells.starts[c],
                   cells.order.begin() + cells.starts[c + 1]);
  }
  std::vector<Hull> sorted;
  for (auto& [number, hull] : hulls) {
    std::sort(hull.members.begin(), hull.members.end());
    hull.ring = hull_of(points, hull.members);
    sorted.push_back(std::move(hull));
  }
  // A hull's ring starts at its lexicographically smallest vertex.
  std::sort(sorted.begin(), sorted.end(), [](const Hull& a, const Hull& b) {
    return std::lexicographical_compare(a.ring[0].begin(), a.ring[0].end(), b.ring[0].begin(),
                                        b.ring[0].end());
  });
  return sorted;
}

}  // namespace arcbid
