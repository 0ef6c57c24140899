// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/task_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/digest.hpp"

namespace arcbid {
namespace {

constexpr double least_piece_m = 1e-3;  // what a drone's navigation cannot tell from nothing

std::size_t pieces_of(double length_m, double piece_m) {
  const double whole = std::floor(length_m / piece_m);
  const bool remainder = length_m - whole * piece_m >= least_piece_m;
  return std::max<std::size_t>(1, static_cast<std::size_t>(whole) + (remainder ? 1 : 0));
}

std::size_t pieces_of(const std::vector<double>& lengths_m, double piece_m) {
  std::size_t count = 0;
  for (const double length : lengths_m) count += pieces_of(length, piece_m);
  return count;
}

/// The smallest piece length, to the precision of a bisection, that keeps the limit.
double raise(const std::vector<double>& lengths_m, double piece_m, std::size_t limit) {
  double low = piece_m, high = *std::max_element(lengths_m.begin(), lengths_m.end());
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (pieces_of(lengths_m, middle) <= limit ? high : low) = middle;
  }
  return high;
}

/// Of the arcs that fill gaps only where there are no others: where one view is all that is missed
/// they are lines too short to cut everything else by.
double shortest_m(const std::vector<Arc>& arcs, const std::vector<double>& lengths_m) {
  double of_gaps_m = std::numeric_limits<double>::infinity(), of_others_m = of_gaps_m;
  for (std::size_t m = 0; m < arcs.size(); ++m) {
    double& least_m = arcs[m].kind == ArcKind::gap ? of_gaps_m : of_others_m;
    least_m = std::min(least_m, lengths_m[m]);
  }
  return std::isfinite(of_others_m) ? of_others_m : of_gaps_m;
}

void cut_arc(const Arc& arc, double length_m, double piece_m, std::vector<Task>& tasks) {
  const std::size_t count = pieces_of(length_m, piece_m);
  for (std::size_t k = 0; k < count; ++k) {
    Task task{.id = {static_cast<std::uint32_t>(tasks.size())}, .arc = arc.id};
    task.payload = arc.payload;
    task.from_m = static_cast<double>(k) * piece_m;
    task.to_m = k + 1 == count ? length_m : static_cast<double>(k + 1) * piece_m;
    const auto polyline = part(arc.waypoints, task.from_m, task.to_m);
    task.first_m = polyline.front().position_m;
    task.last_m = polyline.back().position_m;
    tasks.push_back(task);
  }
}

std::uint64_t digest_of(const std::vector<Task>& tasks) {
  Digest d;
  for (const Task& task : tasks) {
    d.add(std::uint64_t{task.arc.value}).add(task.from_m).add(task.to_m);
    d.add(static_cast<std::uint64_t>(task.payload));
    for (int axis = 0; axis < 3; ++axis) d.add(task.first_m[axis]).add(task.last_m[axis]);
  }
  return d.value();
}

}  // namespace

TaskSet split(const std::vector<Arc>& arcs, std::optional<double> split_m,
              std::uint32_t max_tasks) {
  TaskSet set;
  std::vector<double> lengths_m;
  for (const Arc& arc : arcs) lengths_m.push_back(length_m(arc.waypoints));
  if (!arcs.empty()) {
    const double asked_m =
        std::max(split_m ? *split_m : shortest_m(arcs, lengths_m), 10 * least_piece_m);
    set.piece_m = asked_m;
    const std::size_t wanted = pieces_of(lengths_m, asked_m);
    const std::size_t limit = std::max<std::size_t>(max_tasks, arcs.size());
    if (wanted > limit) {
      set.piece_m = raise(lengths_m, asked_m, limit);
      set.warnings.push_back(
          fmt::format("pieces of {:.3g} m would make {} tasks, more than max_tasks = {}: {}",
                      asked_m, wanted, max_tasks,
                      arcs.size() > max_tasks
                          ? fmt::format("all {} arcs stay whole, which is still more", arcs.size())
                          : fmt::format("pieces of {:.3g} m are used", set.piece_m)));
    }
  }
  for (std::size_t m = 0; m < arcs.size(); ++m)
    cut_arc(arcs[m], lengths_m[m], set.piece_m, set.tasks);
  for (Task& task : set.tasks) task.value = task.length_m();
  set.digest = digest_of(set.tasks);
  return set;
}

std::vector<Piece> combine(const TaskSet& set, const std::vector<TaskId>& path) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Task& task = set.tasks[path[i].value];
    if (i > 0 && set.same_arc(path[i - 1], path[i])) {
      const Task& last = set.tasks[path[i - 1].value];
      Piece& run = pieces.back();
      // The run must end at the task flown last, or the piece would lie at its far end.
      if (last.to_m == task.from_m && run.to_m == last.to_m) {
        run.to_m = task.to_m;
        continue;
      }
      if (last.from_m == task.to_m && run.from_m == last.from_m) {
        run.from_m = task.from_m;
        continue;
      }
    }
    pieces.push_back({task.arc, task.from_m, task.to_m});
  }
  return pieces;
}

}  // namespace arcbid
