// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/auction/message.hpp"
#include "core/auction/score.hpp"

namespace arcbid {

/// Eq. (5) with its ties: does `bid` of `bidder` win against the best competing bid known? Exact
/// comparison, then the lower agent id; any bid beats none.
bool beats(double bid, AgentId bidder, const Belief& rival);

/// Bundle b_i and path p_i of one agent, and the greedy phase that fills them (phase 1 of CBBA).
///
/// Bids are warped: never above the lowest bid already in the bundle (Johnson, Choi, How 2012).
/// Where gains diminish that changes nothing but rounding; where they do not, the auction could
/// cycle for ever without it.
class Bundle {
 public:
  /// `limit`: L_t, 0 for none.
  Bundle(AgentId self, std::unique_ptr<PathScore> score, std::size_t tasks, std::uint32_t limit);

  /// Adds the best task again and again (eqs. 6, 7, 10) until none beats its rival: among the tasks
  /// whose bid wins, the one with the highest true gain, then the lowest id. `rivals` has an entry
  /// for each task: the best bid of the others.
  void extend(const std::vector<Belief>& rivals);

  /// Releases everything from bundle position `keep` on; the path keeps its order.
  void release_from(std::size_t keep);

  const std::vector<Claim>& claims() const { return claims_; }          ///< in bundle order
  const std::vector<PathStop>& path() const { return score_->path(); }  ///< in flying order

 private:
  struct Choice {
    TaskId task;
    Insertion where;
    bool found = false;
  };
  Choice choose(std::vector<TaskId>& candidates, const std::vector<Belief>& rivals);
  double warped(double gain) const;
  bool wins(TaskId j, double gain, const std::vector<Belief>& rivals) const;

  AgentId self_;
  std::unique_ptr<PathScore> score_;
  std::size_t tasks_;
  std::size_t limit_;
  std::vector<Claim> claims_;
};

}  // namespace arcbid
