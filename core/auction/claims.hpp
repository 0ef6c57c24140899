// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/auction/bundle.hpp"
#include "core/auction/policy.hpp"

namespace arcbid {

/// Consensus by claims: an agent is the only authority on its own bundle; winners are a pure
/// function of everybody's claims. With rebuild the bundle is built anew against the claims of the
/// others whenever one of those that matter changed: the only fixpoint is the sequential greedy
/// allocation of the living agents, whatever the schedule, the topology or the losses. Without, the
/// agent keeps what stands before the first task that it was outbid on, as in published CBBA: that
/// converges too, but the outcome depends on the schedule.
class ClaimsPolicy final : public Policy {
 public:
  ClaimsPolicy(AgentId self, Bundle bundle, std::size_t tasks, bool rebuilds);

  bool prepare() override;
  Decision decide(const View& view) override;
  StatementBody statement() const override { return Claims{bundle_.claims()}; }
  std::vector<Belief> winners(const View& view) const override { return best_claims(view, tasks_); }
  const std::vector<PathStop>& path() const override { return bundle_.path(); }

 private:
  bool build(const std::vector<Belief>& rivals);
  bool keep(const std::vector<Belief>& rivals);

  AgentId self_;
  Bundle bundle_;
  std::size_t tasks_;
  bool rebuilds_;
};

}  // namespace arcbid
