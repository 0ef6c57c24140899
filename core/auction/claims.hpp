// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/auction/bundle.hpp"
#include "core/auction/policy.hpp"

namespace arcbid {

/// Consensus by claims, with rebuild: an agent is the only authority on its own bundle; winners are
/// a pure function of everybody's claims; the bundle is built anew against the claims of the others
/// whenever one of those that matter changed. The only fixpoint is the sequential greedy allocation
/// of the living agents, whatever the schedule, the topology or the losses.
class ClaimsPolicy final : public Policy {
 public:
  ClaimsPolicy(AgentId self, Bundle bundle, std::size_t tasks);

  Decision decide(const View& view) override;
  StatementBody statement() const override { return Claims{bundle_.claims()}; }
  std::vector<Belief> winners(const View& view) const override { return best_claims(view, tasks_); }
  const std::vector<PathStop>& path() const override { return bundle_.path(); }

 private:
  AgentId self_;
  Bundle bundle_;
  std::size_t tasks_;
  std::optional<std::vector<Belief>> rivals_;  // what the bundle was last built against
};

}  // namespace arcbid
