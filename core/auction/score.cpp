// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/score.hpp"

#include "core/auction/score_append.hpp"
#include "core/auction/score_discounted.hpp"
#include "core/auction/score_distance.hpp"
#include "core/base/error.hpp"

namespace arcbid {

std::unique_ptr<PathScore> make_score(const TaskSet& set, const Uav& uav,
                                      const AuctionSettings& settings, const Transit& transit) {
  const double rho = settings.discount_per_s;
  switch (settings.score) {
    case ScoreKind::minimax:
      return std::make_unique<DistanceScore>(set, uav, transit, DistanceScore::Gain::whole_tour);
    case ScoreKind::minimax_long_first:
      return std::make_unique<DistanceScore>(set, uav, transit, DistanceScore::Gain::long_first);
    case ScoreKind::minisum:
      return std::make_unique<DistanceScore>(set, uav, transit, DistanceScore::Gain::added);
    case ScoreKind::independent:
    case ScoreKind::discounted_append:
      return std::make_unique<AppendScore>(set, uav, transit, rho,
                                           settings.score == ScoreKind::independent);
    case ScoreKind::discounted_insert:
    case ScoreKind::discounted_insert_warped:
      return std::make_unique<DiscountedScore>(set, uav, transit, rho);
  }
  check(false, "every score has a class");
  return nullptr;
}

}  // namespace arcbid
