// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/pull.hpp"

#include <algorithm>
#include <utility>

#include "core/airspace/corridors.hpp"

namespace arcbid {
namespace {

constexpr int kMostRounds = 3;     // of moving every bend once
constexpr double kWorthIt = 0.99;  // another round follows one that gained a per cent
constexpr int kHalvings = 5;       // of how far a bend is moved
constexpr std::size_t kBendsOfAnEnd = 2;

Vec3 foot(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 step = to - from;
  const double squared = step.squaredNorm();
  if (squared == 0) return from;
  return from + std::clamp((p - from).dot(step) / squared, 0.0, 1.0) * step;
}

void move_bend(const FreeGrid& grid, const Vec3& before, Vec3& bend, const Vec3& after) {
  const Vec3 start = bend, goal = foot(bend, before, after);
  double share = 0, step = 0.5;
  for (int k = 0; k < kHalvings; ++k, step /= 2) {
    const Vec3 p = start + (share + step) * (goal - start);
    if (!grid.sees(before, p) || !grid.sees(p, after)) continue;
    share += step;
    bend = p;
  }
}

}  // namespace

void shorten(const FreeGrid& grid, std::vector<Vec3>& way) {
  std::size_t kept = 0;
  for (std::size_t n = 1; n + 1 < way.size();) {
    // The farthest that is seen from the last point kept, but at least the next one.
    std::size_t next = way.size() - 1;
    while (next > n && !grid.sees(way[kept], way[next])) --next;
    way[++kept] = way[next];
    n = next + 1;
    if (next + 1 == way.size()) {
      way.resize(kept + 1);
      return;
    }
  }
  if (way.size() > 1) {
    way[++kept] = way.back();
    way.resize(kept + 1);
  }
}

void pull(const FreeGrid& grid, std::vector<Vec3>& way) {
  shorten(grid, way);
  double length_m = way_length_m(way);
  for (int round = 0; round < kMostRounds && way.size() > 2; ++round) {
    for (std::size_t n = 1; n + 1 < way.size(); ++n)
      move_bend(grid, way[n - 1], way[n], way[n + 1]);
    shorten(grid, way);
    const double before_m = std::exchange(length_m, way_length_m(way));
    if (length_m > kWorthIt * before_m) return;
  }
}

void pull_end(const FreeGrid& grid, std::vector<Vec3>& way) {
  while (way.size() > 2 && grid.sees(way[way.size() - 3], way.back())) way.erase(way.end() - 2);
  for (std::size_t bends = 0; bends < kBendsOfAnEnd && way.size() > bends + 2; ++bends) {
    const std::size_t n = way.size() - 2 - bends;
    move_bend(grid, way[n - 1], way[n], way[n + 1]);
  }
}

}  // namespace arcbid
