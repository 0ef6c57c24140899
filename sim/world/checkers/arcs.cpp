// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace arcbid {
namespace {

long long mm(double metres) {
  return std::llround(metres * 1000);
}

double metres(const Arc& arc) {
  double sum = 0;
  for (std::size_t n = 1; n < arc.waypoints.size(); ++n)
    sum += (arc.waypoints[n].position_m - arc.waypoints[n - 1].position_m).norm();
  return sum;
}

/// Where one is after `at_m` along the arc.
Vec3 place(const Arc& arc, double at_m) {
  for (std::size_t n = 1; n < arc.waypoints.size(); ++n) {
    const Vec3 from = arc.waypoints[n - 1].position_m;
    const Vec3 way = arc.waypoints[n].position_m - from;
    if (at_m <= way.norm()) return from + way * (at_m / way.norm());
    at_m -= way.norm();
  }
  return arc.waypoints.back().position_m;
}

/// The arc's pieces; what would be left at its end is too short to be one of its own.
void cut(const Arc& arc, double piece_m, std::vector<Stretch>& pieces) {
  const double length_m = metres(arc);
  for (double from_m = 0; length_m - from_m >= 1e-3;) {
    const bool is_last = length_m - (from_m + piece_m) < 1e-3;
    const double to_m = is_last ? length_m : from_m + piece_m;
    pieces.push_back({arc.id.value, from_m, to_m, place(arc, from_m), place(arc, to_m)});
    from_m = to_m;
  }
}

std::vector<Stretch> cut(const std::vector<Arc>& arcs, double piece_m) {
  std::vector<Stretch> pieces;
  for (const Arc& arc : arcs) cut(arc, piece_m, pieces);
  return pieces;
}

}  // namespace

std::vector<Stretch> cut(const Mission& mission) {
  const std::vector<Arc>& arcs = mission.arcs;
  // Arcs that fill gaps do not say how all others are cut, unless there are no others.
  const bool only_gaps = std::all_of(arcs.begin(), arcs.end(),
                                     [](const Arc& arc) { return arc.kind == ArcKind::gap; });
  double shortest_m = std::numeric_limits<double>::infinity(), longest_m = 0;
  for (const Arc& arc : arcs) {
    if (only_gaps || arc.kind != ArcKind::gap) shortest_m = std::min(shortest_m, metres(arc));
    longest_m = std::max(longest_m, metres(arc));
  }
  const double piece_m = std::max(mission.auction.split_m.value_or(shortest_m), 0.01);
  const std::size_t most = std::max<std::size_t>(mission.auction.max_tasks, arcs.size());
  std::vector<Stretch> pieces = cut(arcs, piece_m);
  if (pieces.size() <= most) return pieces;
  // The shortest pieces that are few enough lie between these two.
  for (double too_short_m = piece_m; longest_m - too_short_m > 1e-9;) {
    const double middle_m = (too_short_m + longest_m) / 2;
    (cut(arcs, middle_m).size() <= most ? longest_m : too_short_m) = middle_m;
  }
  return cut(arcs, longest_m);
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

void take_places(const std::vector<Task>& tasks, std::vector<Stretch>& pieces) {
  for (std::size_t j = 0; j < std::min(tasks.size(), pieces.size()); ++j) {
    pieces[j].first_m = tasks[j].first_m;
    pieces[j].last_m = tasks[j].last_m;
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
    if (reached_mm[arc.id.value] != mm(metres(arc)))
      findings.add(now_ns, "cover", "arc {}: {} of {} mm", arc.id.value, reached_mm[arc.id.value],
                   mm(metres(arc)));
}

}  // namespace arcbid
