// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/polygons.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/partition_2.h>
#include <CGAL/property_map.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <list>
#include <numeric>
#include <span>

namespace arcbid::readers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits =
    CGAL::Partition_traits_2<Kernel, CGAL::Pointer_property_map<Kernel::Point_2>::const_type>;
using Corners = std::span<const std::uint32_t>;

/// Above this a face is not a face of a structure, and the partition would take seconds.
constexpr std::size_t kMostCorners = 10'000;

/// The polygon in its own plane, counter-clockwise (the normal is Newell's sum).
std::vector<Kernel::Point_2> flatten(const std::vector<Vec3>& points, Corners corners) {
  const Vec3& origin = points[corners[0]];
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = points[corners[i]] - origin;
    const Vec3 b = points[corners[(i + 1) % corners.size()]] - origin;
    normal += a.cross(b);
  }
  const Vec3 u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
  std::vector<Kernel::Point_2> flat;
  for (const std::uint32_t corner : corners) {
    const Vec3 offset = points[corner] - origin;
    flat.emplace_back(offset.dot(u), offset.dot(v));
  }
  return flat;
}

bool finite(const std::vector<Kernel::Point_2>& polygon) {
  return std::all_of(polygon.begin(), polygon.end(), [](const Kernel::Point_2& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y());
  });
}

void fan(Corners corners, RawGeometry& raw) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    raw.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

void triangulate(Corners corners, RawGeometry& raw) {
  if (corners.size() == 3) return fan(corners, raw);
  const auto flat = flatten(raw.points, corners);
  // A polygon that crosses itself has no inside to cut up; a fan keeps its surface in place.
  if (!finite(flat) || !CGAL::is_simple_2(flat.begin(), flat.end(), Kernel()) ||
      CGAL::is_convex_2(flat.begin(), flat.end(), Kernel())) {
    return fan(corners, raw);
  }
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const Traits traits(CGAL::make_property_map(flat));
  std::list<Traits::Polygon_2> pieces;
  CGAL::approx_convex_partition_2(order.begin(), order.end(), std::back_inserter(pieces), traits);
  for (const auto& piece : pieces) {
    std::vector<std::uint32_t> part;
    for (const std::size_t i : piece.container()) part.push_back(corners[i]);
    fan(part, raw);
  }
}

std::string place(const Polygons& polygons, std::size_t face) {
  if (polygons.lines.empty()) return fmt::format(" face {}:", face);
  return fmt::format("{}:", polygons.lines[face]);
}

}  // namespace

void add_triangles(const Source& source, const Polygons& polygons, RawGeometry& raw) {
  std::size_t begin = 0, too_few = 0;
  std::vector<std::uint32_t> corners;
  for (std::size_t face = 0; face < polygons.ends.size(); ++face) {
    corners.clear();
    for (; begin < polygons.ends[face]; ++begin) {
      const std::int64_t index = polygons.corners[begin];
      if (index < 0 || index >= static_cast<std::int64_t>(raw.points.size())) {
        throw InputError(fmt::format(
            "{}:{} a corner is vertex {} (counted from 0), but the file has {} vertices",
            source.name, place(polygons, face), index, grouped(raw.points.size())));
      }
      corners.push_back(static_cast<std::uint32_t>(index));
    }
    if (corners.size() > kMostCorners) {
      throw InputError(fmt::format("{}:{} has {} corners: legal are 3 to {}", source.name,
                                   place(polygons, face), grouped(corners.size()),
                                   grouped(kMostCorners)));
    }
    if (corners.size() < 3) {
      ++too_few;
    } else {
      triangulate(corners, raw);
    }
  }
  if (too_few > 0) {
    raw.warnings.push_back("dropped " + counted(too_few, "face") +
                           " with fewer than three corners");
  }
}

}  // namespace arcbid::readers
