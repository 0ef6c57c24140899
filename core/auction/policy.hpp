// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/bundle.hpp"
#include "core/auction/message.hpp"
#include "core/auction/score.hpp"
#include "core/auction/view.hpp"

namespace arcbid {

/// What a decision did.
struct Decision {
  bool changed = false;  ///< the statement to be made differs from the last one
  bool settled = true;   ///< deciding again on the same view would change nothing
};

/// A consensus policy: how an agent makes up its mind from the newest statements of all. The rest
/// (who has heard what, who lives, when agreement is proven) is the same for every policy.
class Policy {
 public:
  virtual ~Policy() = default;
  /// Makes up the mind as long as nothing was heard of anybody: there is time for it before the
  /// start. Returns whether that is a decision; else the first one is the first on a view.
  virtual bool prepare() { return false; }
  /// One decision on exactly `view`.
  virtual Decision decide(const View& view) = 0;
  /// What this agent now states about itself.
  virtual StatementBody statement() const = 0;
  /// z_i and y_i as this agent believes them, an entry for each task.
  virtual std::vector<Belief> winners(const View& view) const = 0;
  /// Whether all living members believe the same, once everybody is settled on `view`. True by
  /// construction where winners are a function of the view; published CBBA can come to rest in
  /// disagreement.
  virtual bool agrees(const View&) const { return true; }
  /// p_i.
  virtual const std::vector<PathStop>& path() const = 0;
};

/// Whether bids are warped under this score.
Bundle::Bids bids_of(ScoreKind score);

/// Bundle and path of one agent, with the score and the kind of bids that the mission asks for.
Bundle make_bundle(const TaskSet& set, const Uav& self, const AuctionSettings& settings,
                   const Transit& transit);

/// The policy that the mission asks for. `set` and `transit` must outlive it; `roster`: ascending
/// ids.
std::unique_ptr<Policy> make_policy(const TaskSet& set, const Uav& self,
                                    const std::vector<AgentId>& roster,
                                    const AuctionSettings& settings, const Transit& transit);

}  // namespace arcbid
