// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace arcbid {
namespace {

long long mm(double metres) {
  return std::llround(metres * 1000);
}

long long length_mm(const Arc& arc) {
  return mm((arc.waypoints.back().position_m - arc.waypoints.front().position_m).norm());
}

}  // namespace

std::vector<Stretch> cut(const Mission& mission) {
  const double piece_m = mission.auction.split_m.value();
  std::vector<Stretch> pieces;
  for (const Arc& arc : mission.arcs) {
    const Vec3 first = arc.waypoints.front().position_m;
    const Vec3 way = arc.waypoints.back().position_m - first;
    const double length_m = way.norm();
    double from_m = 0;
    while (length_m - from_m >= 1e-3) {
      // What would be left is too short to be a piece of its own.
      const bool is_last = length_m - (from_m + piece_m) < 1e-3;
      const double to_m = is_last ? length_m : from_m + piece_m;
      pieces.push_back({arc.id.value, from_m, to_m, first + way * (from_m / length_m),
                        first + way * (to_m / length_m)});
      from_m = to_m;
    }
  }
  return pieces;
}

void check_split(const std::vector<Stretch>& expected, const std::vector<Task>& tasks,
                 Findings& findings) {
  if (expected.size() != tasks.size())
    findings.add(0, "split", "{} tasks, not {}", tasks.size(), expected.size());
  for (std::size_t j = 0; j < std::min(expected.size(), tasks.size()); ++j) {
    const bool same = tasks[j].arc.value == expected[j].arc &&
                      mm(tasks[j].from_m) == mm(expected[j].from_m) &&
                      mm(tasks[j].to_m) == mm(expected[j].to_m);
    const bool same_place = (tasks[j].first_m - expected[j].first_m).norm() < 1e-3 &&
                            (tasks[j].last_m - expected[j].last_m).norm() < 1e-3;
    if (!same || !same_place) findings.add(0, "split", "task {} is cut elsewhere", j);
  }
}

void check_cover(const Mission& mission, std::vector<Piece> pieces, TimeNs now_ns,
                 Findings& findings) {
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return std::tie(a.arc, a.from_m) < std::tie(b.arc, b.from_m);
  });
  std::vector<long long> reached_mm(mission.arcs.size(), 0);
  for (const Piece& piece : pieces) {
    long long& reached = reached_mm.at(piece.arc.value);
    if (mm(piece.from_m) != reached)
      findings.add(now_ns, "cover", "arc {}: a piece begins at {} mm, the one before ended at {}",
                   piece.arc.value, mm(piece.from_m), reached);
    reached = mm(piece.to_m);
  }
  for (const Arc& arc : mission.arcs)
    if (reached_mm[arc.id.value] != length_mm(arc))
      findings.add(now_ns, "cover", "arc {}: {} of {} mm", arc.id.value, reached_mm[arc.id.value],
                   length_mm(arc));
}

}  // namespace arcbid
