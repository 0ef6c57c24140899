// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/auction/bundle.hpp"

namespace arcbid {

/// What one UAV bids for tasks that it takes in a given order. Bids are a pure function of the
/// mission and of that order: anybody who knows both can recompute them, bit for bit where exp() is
/// the same (nothing else but IEEE arithmetic goes into a score). Under claims-keep an agent sums
/// its path anew after a release, and its MiniMax bids may differ in the last bits.
class BundleReplay {
 public:
  BundleReplay(std::unique_ptr<PathScore> score, Bundle::Bids bids);

  /// What `task`, which is not among the claims, would be bid as the next one.
  double bid(TaskId task);
  /// Takes it: the next claim.
  void take(TaskId task);
  /// Goes back to the first `claims` claims.
  void keep(std::size_t claims);

  const std::vector<Claim>& claims() const { return claims_; }

 private:
  double bid(double gain) const;

  std::unique_ptr<PathScore> score_;
  Bundle::Bids bids_;
  std::vector<Claim> claims_;
  std::vector<Insertion> steps_;  // how each was added
};

/// The replay of `uav` in a mission with these settings.
BundleReplay make_replay(const TaskSet& set, const Uav& uav, const AuctionSettings& settings,
                         const Transit& transit);

}  // namespace arcbid
