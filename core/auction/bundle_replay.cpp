// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/bundle_replay.hpp"

#include <algorithm>
#include <utility>

#include "core/auction/policy.hpp"

namespace arcbid {

BundleReplay::BundleReplay(std::unique_ptr<PathScore> score, Bundle::Bids bids)
    : score_(std::move(score)), bids_(bids) {}

double BundleReplay::bid(double gain) const {
  if (claims_.empty() || bids_ == Bundle::Bids::true_gains) return gain;
  return std::min(gain, claims_.back().bid);
}

double BundleReplay::bid(TaskId task) {
  return bid(score_->best(task).gain);
}

void BundleReplay::take(TaskId task) {
  const Insertion where = score_->best(task);
  claims_.push_back({task, bid(where.gain)});
  steps_.push_back(where);
  score_->insert(task, where);
}

void BundleReplay::keep(std::size_t claims) {
  if (claims == claims_.size()) return;
  claims_.resize(claims);
  steps_.resize(claims);
  score_->assign({});
  for (std::size_t n = 0; n < claims; ++n) score_->insert(claims_[n].task, steps_[n]);
}

BundleReplay make_replay(const TaskSet& set, const Uav& uav, const AuctionSettings& settings,
                         const Transit& transit) {
  return {make_score(set, uav, settings, transit), bids_of(settings.score)};
}

}  // namespace arcbid
