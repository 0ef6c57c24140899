// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/auction/limits.hpp"
#include "core/auction/score.hpp"

namespace arcbid {

/// MiniMax and MiniSum: both ask only how many metres the cheapest insertion adds to the tour home
/// -> path -> home, or, where nobody returns home, home -> path. The cheapest insertion of every
/// task still asked for is kept, and an insertion costs O(1) for each. A task whose best place was
/// just taken keeps its old cost as a lower bound, and is scanned again only when somebody asks for
/// the exact one. Lengths are asked for many at once: it is what most of an auction's time goes to.
/// The cheapest insertion makes the shortest tour: when that is too long for the UAV, all are; and
/// no longer path has a shorter one.
class DistanceScore final : public PathScore {
 public:
  /// What a task gains. whole_tour: MiniMax, minus the time of the whole tour, which has
  /// diminishing gains because transits obey the triangle inequality. long_first: the same and
  /// twice the task's own time, which does not change while the path grows, so that gains diminish
  /// too. added: MiniSum, minus the time added; its gains do not.
  enum class Gain : std::uint8_t { whole_tour, long_first, added };
  DistanceScore(const TaskSet& set, const Uav& uav, const Transit& transit, Gain gain);

  void assign(std::vector<PathStop> path) override;
  Insertion best(TaskId task) override;
  Bound bound(TaskId task) override;
  void insert(TaskId task, const Insertion& where) override;
  void retire(TaskId task) override;
  bool diminishing() const override { return gain_ != Gain::added; }
  const std::vector<PathStop>& path() const override { return path_; }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  struct Cached {
    double detour_m = 0;
    std::uint32_t position = 0;
    std::uint32_t slot = none;  // among the active; none: not asked for since assign()
    bool reversed = false;
    bool exact = false;  // else detour_m is a lower bound and the place means nothing
  };
  /// What one place between two stops costs: to a task's first and last point, and on from there.
  struct Lengths {
    std::vector<double> to_first, to_last, from_first, from_last;
    void resize(std::size_t size);
  };

  const Vec3& entry(const PathStop& stop) const;
  const Vec3& exit(const PathStop& stop) const;
  void add(Points& points, std::size_t before, const Vec3& point) const;
  double leg_m(std::size_t position) const;
  double detour_m(const Lengths& lengths, std::size_t n, double leg_m, bool& reversed) const;
  void scan(TaskId task);
  Cached& known(TaskId task);
  double gain(double detour_m, TaskId task) const;
  void measure(std::size_t position, Lengths& lengths) const;
  void update(std::uint32_t split);

  const TaskSet& set_;
  const Uav uav_;
  const Limits limits_;
  const Transit& transit_;
  const Gain gain_;
  std::vector<PathStop> path_;
  Points before_;                   // before_[l]: from where position l is flown to; home first
  Points after_;                    // after_[l]: to where from there; home last, where all return
  std::vector<double> transits_m_;  // transits_m_[l]: into position l; the last one leads home
  double tour_m_ = 0;
  std::vector<Cached> cached_;  // by task
  std::vector<TaskId> active_;  // tasks whose cached insertion is known
  Points firsts_, lasts_;       // their end points
  Lengths scanned_;             // room to work in
  std::array<Lengths, 2> fresh_;
};

}  // namespace arcbid
