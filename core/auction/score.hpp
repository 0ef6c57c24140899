// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/task_set.hpp"

namespace arcbid {

/// One stop of path p_i: a task, and which way it is flown.
struct PathStop {
  TaskId task;
  bool reversed = false;  ///< from last_m to first_m
  friend bool operator==(const PathStop&, const PathStop&) = default;
};

/// The marginal score of a task that the UAV cannot fly as well (core/auction/limits.hpp): never
/// bid.
inline constexpr double unflyable = -std::numeric_limits<double>::infinity();

/// The best way to take one more task: eqs. (7) and (8), among those that the UAV can fly.
struct Insertion {
  double gain = 0;  ///< c_ij, the marginal score; higher is better, may be negative, or unflyable
  std::uint32_t position = 0;  ///< l*: the task comes before what now stands there
  bool reversed = false;
  friend bool operator==(const Insertion&, const Insertion&) = default;
};

/// An agent's path p_i and what a further task would add to its score S. Ties between equally good
/// insertions: the earlier position, then not reversed. All scores are functions of the insertions
/// made since assign(), in their order.
class PathScore {
 public:
  virtual ~PathScore() = default;

  /// Makes `path` the path.
  virtual void assign(std::vector<PathStop> path) = 0;
  /// c_ij and where, for a task that is not in the path and was not retired since assign().
  virtual Insertion best(TaskId task) = 0;
  /// A number that c_ij cannot exceed, at little cost; `exact` when it is c_ij and best() costs
  /// nothing.
  struct Bound {
    double gain = 0;
    bool exact = false;
  };
  virtual Bound bound(TaskId task) { return {best(task).gain, true}; }
  virtual void insert(TaskId task, const Insertion& where) = 0;
  /// The task will not be asked for again before the next assign().
  virtual void retire(TaskId task) = 0;
  /// Whether c_ij never rises as the path grows (diminishing marginal gains).
  virtual bool diminishing() const = 0;
  virtual const std::vector<PathStop>& path() const = 0;
};

/// The score that the mission asks for, for one UAV:
/// - minimax (Lagoudakis et al. 2005): minus the completion time of the whole path;
/// - minimax_long_first: the same and twice the task's own time: whoever can take a long arc
/// without
///   a long way does so early, and short ones fill up what is left;
/// - minisum: minus the time the task adds to it;
/// - independent: v_j exp(-rho t), t the time to do task j alone, coming from home;
/// - discounted_append (Choi, Brunet, How 2009): v_j exp(-rho t_j), t_j the time at which j is done
///   when it is added at the end of the path;
/// - discounted_insert, discounted_insert_warped: what j adds to the sum of these over the path
///   where it fits best; the two differ in the bids only (Bundle).
/// A task that the UAV has no payload for, or that makes its tour longer than it lasts wherever the
/// score may put it, is unflyable; where some of these places are, the best of the others counts.
std::unique_ptr<PathScore> make_score(const TaskSet& set, const Uav& uav,
                                      const AuctionSettings& settings, const Transit& transit);

}  // namespace arcbid
