// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/auction/limits.hpp"
#include "core/auction/score.hpp"

namespace arcbid {

/// Scores that add a task at the end of the path: S(p) = sum of v_j exp(-rho t_j). Either t_j is
/// when task j is done on that path (Choi, Brunet, How 2009, section V), or, `from_home`, when it
/// would be done were it the only one. Both have diminishing gains: a longer path leads to a task
/// no sooner, by the triangle inequality. Nor does it come home any sooner after the task: a way to
/// fly the task that lasts too long goes on doing so.
class AppendScore final : public PathScore {
 public:
  AppendScore(const TaskSet& set, const Uav& uav, const Transit& transit, double discount_per_s,
              bool from_home);

  void assign(std::vector<PathStop> path) override;
  Insertion best(TaskId task) override;
  void insert(TaskId task, const Insertion& where) override;
  void retire(TaskId) override {}
  bool diminishing() const override { return true; }
  const std::vector<PathStop>& path() const override { return path_; }

 private:
  void fly(const PathStop& stop);
  double transit_s(const Vec3& from, const Vec3& to) const;
  bool can_fly(const Task& task, bool reversed) const;

  const TaskSet& set_;
  const Uav uav_;
  const Limits limits_;
  const Transit& transit_;
  const double discount_per_s_;
  const bool from_home_;
  std::vector<PathStop> path_;
  Vec3 at_m_ = Vec3::Zero();   // where the next leg starts
  double done_s_ = 0;          // and when
  Vec3 end_m_ = Vec3::Zero();  // where the path as it stands ends
  double flown_m_ = 0;         // and what it takes from home to there
};

}  // namespace arcbid
