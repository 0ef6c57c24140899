// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/corridors.hpp"

#include <algorithm>
#include <cmath>

namespace arcbid {
namespace {

constexpr double kOnArc_m = 1e-6;

bool on_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 reach = Vec3::Constant(kOnArc_m);
  if (((p - from.cwiseMin(to) + reach).array() < 0).any()) return false;
  if (((from.cwiseMax(to) + reach - p).array() < 0).any()) return false;
  const Vec3 step = to - from;
  const double share = std::clamp((p - from).dot(step) / step.squaredNorm(), 0.0, 1.0);
  return (from + share * step - p).norm() <= kOnArc_m;
}

}  // namespace

double way_length_m(const std::vector<Vec3>& way) {
  double sum = 0;
  for (std::size_t low = 0, high = way.size() - 1; low < high; ++low, --high) {
    const double first_m = (way[low + 1] - way[low]).norm();
    if (low + 1 == high) return sum + first_m;
    sum += first_m + (way[high - 1] - way[high]).norm();
  }
  return sum;
}

Corridors::Corridors(const std::vector<Arc>& arcs, const Airspace& airspace, const FreeGrid& grid)
    : arcs_(arcs), airspace_(airspace), grid_(grid) {}

std::optional<OnArc> Corridors::find(const Vec3& place) const {
  for (std::uint32_t arc = 0; arc < arcs_.size(); ++arc) {
    const auto& waypoints = arcs_[arc].waypoints;
    for (std::uint32_t s = 0; s + 1 < waypoints.size(); ++s)
      if (on_segment(place, waypoints[s].position_m, waypoints[s + 1].position_m))
        return OnArc{arc, s};
  }
  return std::nullopt;
}

std::vector<Vec3> Corridors::along(const OnArc& from, const Vec3& from_m, const OnArc& to,
                                   const Vec3& to_m) const {
  const auto& waypoints = arcs_[from.arc].waypoints;
  std::vector<Vec3> way{from_m};
  const auto append = [&](const Vec3& p) {
    if (way.back() != p) way.push_back(p);
  };
  for (std::uint32_t s = from.segment; s < to.segment; ++s) append(waypoints[s + 1].position_m);
  for (std::uint32_t s = from.segment; s > to.segment; --s) append(waypoints[s].position_m);
  append(to_m);
  return way;
}

std::optional<Door> Corridors::walk(const Vec3& place, const OnArc& on, int sense) const {
  const auto& waypoints = arcs_[on.arc].waypoints;
  const double stride_m = grid_.cell_m() / 4;
  Door door{{place}, 0};
  for (auto w = static_cast<std::ptrdiff_t>(on.segment) + (sense > 0 ? 1 : 0);
       w >= 0 && w < static_cast<std::ptrdiff_t>(waypoints.size()); w += sense) {
    const Vec3 from = door.at(), to = waypoints[static_cast<std::size_t>(w)].position_m;
    const double steps = std::ceil((to - from).norm() / stride_m);
    for (double k = 1; k <= steps; ++k) {
      const Vec3 p = k < steps ? Vec3(from + k / steps * (to - from)) : to;
      if (!grid_.free(p)) continue;
      door.way.push_back(p);
      door.length_m = way_length_m(door.way);
      return door;
    }
    if (from != to) door.way.push_back(to);
  }
  return std::nullopt;
}

std::vector<Door> Corridors::doors(const Vec3& place, const std::optional<OnArc>& on) const {
  if (grid_.free(place)) return {Door{{place}, 0}};
  std::vector<Door> doors;
  // Arcs may run on the floor, and by rounding a hair under it: those are no homes.
  if (!on && place.z() < grid_.low_m().z()) {
    const Vec3 top(place.x(), place.y(), grid_.low_m().z());
    if (grid_.free(top)) doors.push_back({{place, top}, top.z() - place.z()});
    return doors;
  }
  if (!on) return doors;
  for (const int sense : {-1, 1})
    if (auto door = walk(place, *on, sense)) doors.push_back(std::move(*door));
  const auto& waypoints = arcs_[on->arc].waypoints;
  for (const Access& access : airspace_.accesses) {
    if (access.arc.value != on->arc || access.waypoint >= waypoints.size()) continue;
    const OnArc end{on->arc, access.waypoint};
    Door door{along(*on, place, end, waypoints[access.waypoint].position_m), 0};
    for (std::size_t k = 1; k < access.points.size(); ++k)
      door.way.push_back(access.points[k].position_m);
    door.length_m = way_length_m(door.way);
    doors.push_back(std::move(door));
  }
  return doors;
}

}  // namespace arcbid
