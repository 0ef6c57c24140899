// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/auction/score.hpp"

namespace arcbid {

/// MiniMax and MiniSum: both ask only how many metres the cheapest insertion adds to the tour home
/// -> path -> home, or, where nobody returns home, home -> path. The cheapest insertion of every
/// task still asked for is kept, and an insertion costs O(1) for each. A task whose best place was
/// just taken keeps its old cost as a lower bound, and is scanned again only when somebody asks for
/// the exact one.
class DistanceScore final : public PathScore {
 public:
  /// `whole_tour`: MiniMax, minus the time of the whole tour, which has diminishing gains because
  /// transits obey the triangle inequality. Else MiniSum, minus the time added, which has not.
  DistanceScore(const TaskSet& set, const Uav& uav, const Transit& transit, bool whole_tour);

  void assign(std::vector<PathStop> path) override;
  Insertion best(TaskId task) override;
  Bound bound(TaskId task) override;
  void insert(TaskId task, const Insertion& where) override;
  void retire(TaskId task) override;
  bool diminishing() const override { return whole_tour_; }
  const std::vector<PathStop>& path() const override { return path_; }

 private:
  struct Cached {
    double detour_m = 0;
    std::uint32_t position = 0;
    bool reversed = false;
    bool known = false;  // asked for since assign()
    bool exact = false;  // else detour_m is a lower bound and the place means nothing
  };

  const Vec3& entry(const PathStop& stop) const;
  const Vec3& exit(const PathStop& stop) const;
  const Vec3& before(std::size_t position) const;
  double leg_m(std::size_t position) const;
  Cached at(TaskId task, std::uint32_t position) const;
  void scan(TaskId task);
  Cached& known(TaskId task);
  double gain(TaskId task) const;
  void update(TaskId task, std::uint32_t split);

  const TaskSet& set_;
  const Uav uav_;
  const Transit& transit_;
  const bool whole_tour_;
  std::vector<PathStop> path_;
  std::vector<double> transits_m_;  // transits_m_[l]: into position l; the last one leads home
  double tour_m_ = 0;
  std::vector<Cached> cached_;  // by task
  std::vector<TaskId> active_;  // tasks whose cached insertion is known
};

}  // namespace arcbid
