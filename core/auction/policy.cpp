// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/policy.hpp"

#include <utility>

#include "core/auction/acbba.hpp"
#include "core/auction/bundle.hpp"
#include "core/auction/cbba.hpp"
#include "core/auction/claims.hpp"
#include "core/base/error.hpp"

namespace arcbid {

Bundle::Bids bids_of(ScoreKind score) {
  return score == ScoreKind::discounted_insert ? Bundle::Bids::true_gains : Bundle::Bids::warped;
}

Bundle make_bundle(const TaskSet& set, const Uav& self, const AuctionSettings& settings,
                   const Transit& transit) {
  return Bundle(self.id, make_score(set, self, settings, transit), set.tasks.size(),
                settings.bundle_limit, bids_of(settings.score));
}

std::unique_ptr<Policy> make_policy(const TaskSet& set, const Uav& self,
                                    const std::vector<AgentId>& roster,
                                    const AuctionSettings& settings, const Transit& transit) {
  const std::size_t tasks = set.tasks.size();
  Bundle bundle = make_bundle(set, self, settings, transit);
  switch (settings.policy) {
    case PolicyKind::claims:
    case PolicyKind::claims_keep:
      return std::make_unique<ClaimsPolicy>(self.id, std::move(bundle), tasks,
                                            settings.policy == PolicyKind::claims);
    case PolicyKind::cbba:
    case PolicyKind::cbba_rebuild:
      return std::make_unique<CbbaPolicy>(CbbaState(self.id, roster, std::move(bundle), tasks,
                                                    settings.policy == PolicyKind::cbba_rebuild));
    case PolicyKind::acbba:
      return std::make_unique<AcbbaPolicy>(AcbbaState(self.id, std::move(bundle), tasks));
  }
  check(false, "every policy has a class");
  return nullptr;
}

}  // namespace arcbid
