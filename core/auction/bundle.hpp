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
/// Warped bids are never above the lowest bid already in the bundle (Johnson, Choi, How 2012).
/// Where gains diminish that changes nothing but rounding; where they do not, the auction could
/// cycle for ever without it.
class Bundle {
 public:
  enum class Bids : std::uint8_t { warped, true_gains };

  /// `limit`: L_t, 0 for none.
  Bundle(AgentId self, std::unique_ptr<PathScore> score, std::size_t tasks, std::uint32_t limit,
         Bids bids = Bids::warped);

  /// Adds the best task again and again (eqs. 6, 7, 10) until none beats its rival: among the tasks
  /// whose bid wins, the one with the highest true gain, then the lowest id. `rivals` has an entry
  /// for each task: the best bid of the others.
  void extend(const std::vector<Belief>& rivals);

  /// The bundle that releasing everything and extending would give, bit for bit, at less cost: what
  /// the rivals' changes cannot have touched is kept. Returns whether the claims changed.
  bool rebuild(const std::vector<Belief>& rivals);

  /// How many claims, from the first on, still beat their rivals.
  std::size_t still_won(const std::vector<Belief>& rivals) const;

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
  static constexpr std::uint32_t never = UINT32_MAX;

  Choice choose(std::vector<TaskId>& candidates, const std::vector<Belief>& rivals);
  /// The bid for a task whose gain is `gain`, as the bundle's entry number `step`.
  double bid(double gain, std::size_t step) const;
  bool wins(TaskId j, double gain, std::size_t step, const std::vector<Belief>& rivals) const;
  void fill(const std::vector<Belief>& rivals);
  std::vector<TaskId> candidates() const;
  std::vector<TaskId> easier(const std::vector<Belief>& rivals) const;
  bool overtakes(TaskId j, std::size_t step, const std::vector<Belief>& rivals);
  bool replay(std::size_t& steps, std::vector<TaskId> easier, const std::vector<Belief>& rivals);
  void cut(std::size_t keep);

  AgentId self_;
  std::unique_ptr<PathScore> score_;
  std::size_t tasks_;
  std::size_t limit_;
  Bids bids_;
  std::vector<Claim> claims_;
  std::vector<Insertion> steps_;           // how each claim was added
  std::vector<std::uint32_t> retired_at_;  // by task: the step at which it lost for good, or never
  std::vector<Belief> rivals_;             // what was last built against; empty: nothing yet
  bool from_scratch_ = false;  // the bundle is the first steps of a build against rivals_
  bool complete_ = false;      // and nothing more won against them
};

}  // namespace arcbid
