// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/claims.hpp"

#include <utility>

namespace arcbid {

ClaimsPolicy::ClaimsPolicy(AgentId self, Bundle bundle, std::size_t tasks, bool rebuilds)
    : self_(self), bundle_(std::move(bundle)), tasks_(tasks), rebuilds_(rebuilds) {}

bool ClaimsPolicy::prepare() {
  build(std::vector<Belief>(tasks_));
  return true;
}

Decision ClaimsPolicy::decide(const View& view) {
  return {.changed = build(best_claims(view, tasks_, self_)), .settled = true};
}

bool ClaimsPolicy::build(const std::vector<Belief>& rivals) {
  return rebuilds_ ? bundle_.rebuild(rivals) : keep(rivals);
}

bool ClaimsPolicy::keep(const std::vector<Belief>& rivals) {
  const std::vector<Claim> before = bundle_.claims();
  bundle_.release_from(bundle_.still_won(rivals));
  bundle_.extend(rivals);
  return bundle_.claims() != before;
}

}  // namespace arcbid
