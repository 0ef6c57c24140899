// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/auction/score.hpp"

namespace arcbid {

/// Choi's time-discounted reward (Choi, Brunet, How 2009, section V): S(p) = sum over the path of
/// v_j exp(-rho t_j), t_j the time at which piece j is done and v_j its length in metres. Best
/// insertion, so the gains do not diminish and bids must be warped. An insertion is priced in O(1)
/// from the times before it and the value after it: a detour of d seconds scales the rest of the
/// path by exp(-rho d).
class DiscountedScore final : public PathScore {
 public:
  DiscountedScore(const TaskSet& set, const Uav& uav, const Transit& transit,
                  double discount_per_s);

  void assign(std::vector<PathStop> path) override;
  Insertion best(TaskId task) override;
  void insert(TaskId task, const Insertion& where) override;
  void retire(TaskId) override {}
  bool diminishing() const override { return false; }
  const std::vector<PathStop>& path() const override { return path_; }

 private:
  const Vec3& entry(const PathStop& stop) const;
  const Vec3& exit(const PathStop& stop) const;
  double transit_s(const Vec3& from, const Vec3& to) const;
  double gain(TaskId task, std::size_t position, bool reversed) const;
  void refresh();

  const TaskSet& set_;
  const Uav uav_;
  const Transit& transit_;
  const double discount_per_s_;
  std::vector<PathStop> path_;
  std::vector<double> done_s_;      // done_s_[l]: when the first l stops are done; done_s_[0] = 0
  std::vector<double> rest_value_;  // rest_value_[l]: score of the stops from l on
};

}  // namespace arcbid
