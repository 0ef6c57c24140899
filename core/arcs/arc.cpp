// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/arc.hpp"

#include <algorithm>

#include "core/base/digest.hpp"
#include "core/base/error.hpp"

namespace arcbid {

std::string_view name(ArcKind kind) {
  switch (kind) {
    case ArcKind::outline:
      return "outline";
    case ArcKind::top_row:
      return "top_row";
    case ArcKind::underside_row:
      return "underside_row";
    case ArcKind::gap:
      return "gap";
  }
  return "?";
}

double length_m(const std::vector<Waypoint>& polyline) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    sum += (polyline[i].position_m - polyline[i - 1].position_m).norm();
  return sum;
}

namespace {

Waypoint between(const Waypoint& a, const Waypoint& b, double fraction) {
  Vec3 look = a.look + fraction * (b.look - a.look);
  const double norm = look.norm();
  // Opposite looks cancel half-way; the nearer end's direction is then as good as any.
  look = norm > 1e-9 ? Vec3(look / norm) : (fraction < 0.5 ? a.look : b.look);
  return {a.position_m + fraction * (b.position_m - a.position_m), look};
}

}  // namespace

std::vector<Waypoint> part(const std::vector<Waypoint>& polyline, double from_m, double to_m) {
  check(polyline.size() >= 2 && from_m >= 0 && from_m < to_m, "part() of a proper interval");
  std::vector<Waypoint> cut;
  const auto append = [&cut](const Waypoint& w) {
    if (cut.empty() || cut.back().position_m != w.position_m) cut.push_back(w);
  };
  double start_m = 0;
  for (std::size_t i = 1; i < polyline.size() && start_m < to_m; ++i) {
    const Waypoint& a = polyline[i - 1];
    const Waypoint& b = polyline[i];
    const double segment_m = (b.position_m - a.position_m).norm();
    const double end_m = start_m + segment_m;
    if (end_m > from_m) {
      append(from_m <= start_m ? a : between(a, b, (from_m - start_m) / segment_m));
      append(to_m >= end_m ? b : between(a, b, (to_m - start_m) / segment_m));
    }
    start_m = end_m;
  }
  return cut;
}

std::vector<Waypoint> reversed(std::vector<Waypoint> polyline) {
  std::reverse(polyline.begin(), polyline.end());
  return polyline;
}

std::uint64_t digest(const std::vector<Arc>& arcs) {
  Digest d;
  for (const Arc& arc : arcs) {
    d.add(std::uint64_t{arc.id.value}).add(static_cast<std::uint64_t>(arc.kind));
    d.add(static_cast<std::uint64_t>(arc.payload)).add(std::uint64_t{arc.waypoints.size()});
    for (const Waypoint& w : arc.waypoints)
      for (int axis = 0; axis < 3; ++axis) d.add(w.position_m[axis]).add(w.look[axis]);
  }
  return d.value();
}

}  // namespace arcbid
