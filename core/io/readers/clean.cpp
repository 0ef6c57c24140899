// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/clean.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "core/base/digest.hpp"

namespace arcbid::readers {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Old position to new one, kNone for what is dropped.
using Remap = std::vector<std::uint32_t>;

/// Nothing on Earth is farther away, in any unit; beyond it squares of lengths lose their meaning.
constexpr double kFarthest = 1e12;

bool usable(const Vec3& point) {
  return (point.array().abs() < kFarthest).all();
}

std::uint64_t hash(const Vec3& point) {
  std::uint64_t state = 0;
  for (int axis = 0; axis < 3; ++axis) {
    state = Digest::mix(state ^ std::bit_cast<std::uint64_t>(point[axis]));
  }
  return state;
}

/// Keeps the first of equal points, in order. An open-addressing table of positions: one array, no
/// allocation for each point, and nothing is ever iterated in table order.
Remap merge_equal(std::vector<Vec3>& points) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), kNone);
  const std::uint64_t mask = table.size() - 1;
  Remap remap(points.size(), kNone);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!usable(points[i])) continue;
    const Vec3 point = points[i] + Vec3::Zero();  // -0.0 becomes 0.0, which it equals
    std::uint64_t slot = hash(point) & mask;
    while (table[slot] != kNone && points[table[slot]] != point) slot = (slot + 1) & mask;
    if (table[slot] == kNone) {
      table[slot] = kept;
      points[kept++] = point;
    }
    remap[i] = table[slot];
  }
  points.resize(kept);
  return remap;
}

/// Height under 1e-7 of the longest side: below what a float coordinate can tell from a line.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).squaredNorm() > 1e-14 * longest * longest;
}

void keep_used_vertices(RawGeometry& raw) {
  Remap remap(raw.points.size(), kNone);
  for (const auto& triangle : raw.triangles) {
    for (const std::uint32_t corner : triangle) remap[corner] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < raw.points.size(); ++i) {
    if (remap[i] == kNone) continue;
    raw.points[kept] = raw.points[i];
    remap[i] = kept++;
  }
  raw.points.resize(kept);
  for (auto& triangle : raw.triangles) {
    for (std::uint32_t& corner : triangle) corner = remap[corner];
  }
}

void clean_mesh(const Source& source, const Remap& remap, RawGeometry& raw) {
  const std::size_t before = raw.triangles.size(), vertices = raw.points.size();
  std::size_t broken = 0;
  std::erase_if(raw.triangles, [&](auto& triangle) {
    for (std::uint32_t& corner : triangle) corner = remap[corner];
    const bool dropped = std::find(triangle.begin(), triangle.end(), kNone) != triangle.end();
    broken += dropped;
    return dropped ||
           !has_area(raw.points[triangle[0]], raw.points[triangle[1]], raw.points[triangle[2]]);
  });
  if (broken > 0) {
    raw.warnings.push_back("dropped " + counted(broken, "triangle") + " with a NaN corner");
  }
  if (const std::size_t flat = before - raw.triangles.size() - broken; flat > 0) {
    raw.warnings.push_back("dropped " + counted(flat, "triangle") + " without area");
  }
  if (raw.triangles.empty()) fail(source, "no triangle of {} has an area", grouped(before));
  keep_used_vertices(raw);
  if (const std::size_t loose = vertices - raw.points.size(); loose > 0 && !raw.repeats_vertices) {
    raw.warnings.push_back("dropped " + counted(loose, "point") + " that no triangle uses");
  }
}

/// The box that holds the middle 99.8 % of the points on each axis.
std::pair<Vec3, Vec3> middle_box(const std::vector<Vec3>& points) {
  const std::size_t cut = points.size() / 1000;
  std::pair<Vec3, Vec3> box;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(points.begin(), points.end(), values.begin(),
                   [axis](const Vec3& point) { return point[axis]; });
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(cut);
    const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(cut);
    std::nth_element(values.begin(), low, values.end());
    box.first[axis] = *low;
    std::nth_element(low, high, values.end());
    box.second[axis] = *high;
  }
  return box;
}

/// A point is an outlier when it is farther from the middle box than that box's own diagonal: a few
/// of them (a bird, a multipath echo) would otherwise set the extent of the whole plan.
void drop_outliers(RawGeometry& raw) {
  constexpr std::size_t kFewest = 1000;  // below, a thousandth of the points is not even one
  if (raw.points.size() < kFewest) return;
  const auto [low, high] = middle_box(raw.points);
  const double reach = (high - low).norm();
  if (reach == 0) return;
  const std::size_t outliers = std::erase_if(raw.points, [&](const Vec3& point) {
    const Vec3 beyond = (low - point).cwiseMax(point - high).cwiseMax(0.0);
    return beyond.norm() > reach;
  });
  if (outliers > 0) {
    raw.warnings.push_back(
        fmt::format("dropped {} farther than {:.4g} (in the file's unit) from the box that holds "
                    "99.8 % of the points",
                    counted(outliers, "outlier"), reach));
  }
}

}  // namespace

void clean(const Source& source, RawGeometry& raw) {
  const std::size_t before = raw.points.size();
  if (before == 0) fail(source, "the file holds no point");
  if (before >= kNone)
    fail(source, "{} points: legal are up to {}", grouped(before), grouped(kNone));
  const std::size_t finite =
      static_cast<std::size_t>(std::count_if(raw.points.begin(), raw.points.end(), usable));
  if (finite == 0)
    fail(source, "none of the {} is finite (NaN or infinite)", counted(before, "point"));
  if (finite < before) {
    raw.warnings.push_back("dropped " + counted(before - finite, "point") +
                           " with NaN or infinity");
  }
  const Remap remap = merge_equal(raw.points);
  if (const std::size_t same = finite - raw.points.size(); same > 0 && !raw.repeats_vertices) {
    raw.warnings.push_back("dropped " + counted(same, "duplicate point"));
  }
  if (raw.triangles.empty()) {
    drop_outliers(raw);
  } else {
    clean_mesh(source, remap, raw);
  }
}

}  // namespace arcbid::readers
