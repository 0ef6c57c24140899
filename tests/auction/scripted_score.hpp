// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "core/auction/score.hpp"

namespace arcbid::testing {

/// A score that does what the test says: `gain` of a task given the path. New stops go to the
/// front, so that the order of the path is never the order of the bundle.
class ScriptedScore final : public PathScore {
 public:
  using Gain = std::function<double(TaskId, const std::vector<PathStop>&)>;
  /// `slack`: how far the bounds of odd tasks lie above their gains.
  explicit ScriptedScore(Gain gain, bool diminishing = true, double slack = 0)
      : gain_(std::move(gain)), diminishing_(diminishing), slack_(slack) {}

  void assign(std::vector<PathStop> path) override {
    path_ = std::move(path);
    retired_.clear();
  }
  Insertion best(TaskId task) override {
    EXPECT_FALSE(retired_.contains(task)) << "task " << task.value << " was retired";
    return {gain_(task, path_), 0, false};
  }
  Bound bound(TaskId task) override {
    const bool exact = task.value % 2 == 0 || slack_ == 0;
    return {best(task).gain + (exact ? 0 : slack_), exact};
  }
  void insert(TaskId task, const Insertion& where) override {
    path_.insert(path_.begin() + where.position, PathStop{task, where.reversed});
  }
  void retire(TaskId task) override { retired_.insert(task); }
  bool diminishing() const override { return diminishing_; }
  const std::vector<PathStop>& path() const override { return path_; }

 private:
  Gain gain_;
  bool diminishing_;
  double slack_;
  std::vector<PathStop> path_;
  std::set<TaskId> retired_;
};

}  // namespace arcbid::testing
