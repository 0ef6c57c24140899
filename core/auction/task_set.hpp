// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// T(k): a piece of one arc, and what an auction needs to know of it. Metres.
struct Task {
  TaskId id;
  ArcId arc;
  double from_m = 0, to_m = 0;  ///< distances along the arc from its first waypoint, from_m < to_m
  Vec3 first_m = Vec3::Zero(), last_m = Vec3::Zero();  ///< where the piece begins and ends
  double value = 0;  ///< to discounted scores: the length in metres, unless it was given
  Payload payload = Payload::any;  ///< what it must be flown with: its arc's
  double length_m() const { return to_m - from_m; }
};

/// The work set T of SC-CBBA (paper, section 3.1, step 1). Every agent makes it by itself from the
/// published arcs; equal digests mean equal sets, bit for bit.
struct TaskSet {
  std::vector<Task> tasks;  ///< by arc, then along the arc; tasks[j].id.value == j
  double piece_m = 0;       ///< the piece length used
  bool return_home = true;  ///< paths end at home; false: at their last task
  std::uint64_t digest = 0;
  std::vector<std::string> warnings;

  /// A_T(k, l) of eq. (3): both pieces come from the same arc.
  bool same_arc(TaskId k, TaskId l) const { return tasks[k.value].arc == tasks[l.value].arc; }
};

/// Eq. (4): cuts every arc into pieces of the shortest arc's length (or `split_m`), the remainder
/// being the last piece. Arcs that fill gaps count as the shortest only where there are no others.
/// A remainder below 1 mm stays with the piece before it. Where that makes more than `max_tasks`
/// pieces the length is raised until it does not, with a warning; where the arcs alone are more,
/// they stay whole.
TaskSet split(const std::vector<Arc>& arcs, std::optional<double> split_m, std::uint32_t max_tasks);

/// A stretch of one arc, won as a whole.
struct Piece {
  ArcId arc;
  double from_m = 0, to_m = 0;  ///< from_m < to_m
  friend bool operator==(const Piece&, const Piece&) = default;
};

/// Eq. (11): neighbours in `path` that are neighbours on the same arc become one piece again.
/// Pieces come in the order of the path.
std::vector<Piece> combine(const TaskSet& set, const std::vector<TaskId>& path);

}  // namespace arcbid
