// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/claims.hpp"

#include <utility>

namespace arcbid {

ClaimsPolicy::ClaimsPolicy(AgentId self, Bundle bundle, std::size_t tasks)
    : self_(self), bundle_(std::move(bundle)), tasks_(tasks) {}

Decision ClaimsPolicy::decide(const View& view) {
  std::vector<Belief> rivals = best_claims(view, tasks_, self_);
  if (rivals_ == rivals) return {};
  const std::vector<Claim> before = bundle_.claims();
  bundle_.release_from(0);
  bundle_.extend(rivals);
  rivals_ = std::move(rivals);
  return {.changed = bundle_.claims() != before, .settled = true};
}

}  // namespace arcbid
