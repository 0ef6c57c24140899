// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/auction/limits.hpp"
#include "core/auction/score.hpp"

namespace arcbid {

/// Time-discounted reward (Choi, Brunet, How 2009, section V): S(p) = sum over the path of v_j
/// exp(-rho t_j), t_j the time at which task j is done. Best insertion, so the gains do not
/// diminish and bids must be warped.
///
/// An insertion before position l is worth own_l exp(-rho T_l) + R_l loss_l, where T_l is when the
/// stops before l are done, R_l what the stops from l on are worth, own_l = v_j exp(-rho w) with w
/// the time to get there and do it, and loss_l = exp(-rho d) - 1 with d the delay of the rest.
/// own_l and loss_l depend on the two neighbours only: they are kept, and an insertion makes two
/// new ones for each task instead of all. A task is not worth more on any path than flown to
/// directly; most tasks of a large fleet lose by that alone and never get a place computed.
class DiscountedScore final : public PathScore {
 public:
  DiscountedScore(const TaskSet& set, const Uav& uav, const Transit& transit,
                  double discount_per_s);

  void assign(std::vector<PathStop> path) override;
  Insertion best(TaskId task) override;
  Bound bound(TaskId task) override;
  void insert(TaskId task, const Insertion& where) override;
  void retire(TaskId task) override;
  bool diminishing() const override { return false; }
  const std::vector<PathStop>& path() const override { return path_; }

 private:
  /// One way of doing a task between two stops: own_l / v_j, and exp(-rho t) of the way on, t from
  /// the task's end to the next stop (unused at the end of the path); and what it adds to the tour.
  struct Place {
    double arrival = 0, onward = 0, added_m = 0;
  };
  struct Slot {
    Place ahead, back;
  };
  const Vec3& entry(const PathStop& stop) const;
  const Vec3& exit(const PathStop& stop) const;
  const Vec3& begin(std::size_t position) const;
  double transit_s(const Vec3& from, const Vec3& to) const;
  double discounted(double seconds) const;
  Slot slot(TaskId task, std::size_t position) const;
  double gain(TaskId task, const Place& place, std::size_t position) const;
  std::vector<Slot>& slots(TaskId task);
  void refresh();

  const TaskSet& set_;
  const Uav uav_;
  const Limits limits_;
  const Transit& transit_;
  const double discount_per_s_;
  std::vector<PathStop> path_;
  std::vector<double> leg_;    // leg_[l]: exp(-rho t), t the transit into stop l
  std::vector<double> leg_m_;  // the same in metres; the last one leads home
  double tour_m_ = 0;
  std::vector<double> discount_;          // discount_[l]: exp(-rho T_l)
  std::vector<double> rest_value_;        // rest_value_[l]: score of the stops from l on
  std::vector<std::vector<Slot>> slots_;  // by task, then position; empty: not asked for
  std::vector<TaskId> active_;            // tasks whose slots are known
  std::vector<double> direct_;            // by task: worth when flown to directly from home
  std::vector<double> work_;              // by task: exp(-rho t), t the time along it
};

}  // namespace arcbid
