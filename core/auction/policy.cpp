// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/policy.hpp"

#include <utility>

#include "core/auction/bundle.hpp"
#include "core/auction/cbba.hpp"
#include "core/auction/claims.hpp"

namespace arcbid {

std::unique_ptr<Policy> make_policy(const TaskSet& set, const Uav& self,
                                    const std::vector<AgentId>& roster,
                                    const AuctionSettings& settings, const Transit& transit) {
  const std::size_t tasks = set.tasks.size();
  Bundle bundle(self.id, make_score(set, self, settings, transit), tasks, settings.bundle_limit);
  if (settings.policy == PolicyKind::cbba)
    return std::make_unique<CbbaPolicy>(CbbaState(self.id, roster, std::move(bundle), tasks));
  return std::make_unique<ClaimsPolicy>(self.id, std::move(bundle), tasks);
}

}  // namespace arcbid
