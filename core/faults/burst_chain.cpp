// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/faults/burst_chain.hpp"

#include <algorithm>

namespace arcbid {
namespace {

/// At multiples of this the state is drawn anew, whatever it was: a bound on how far to look back.
/// Only a chain that nearly alternates ever looks that far.
constexpr std::uint64_t anchor = 1U << 20;

}  // namespace

BurstChain::BurstChain(const Burst& burst, const Chance& chance)
    : chance_(chance),
      good_loss_(burst.good_loss),
      bad_loss_(burst.bad_loss),
      bad_share_((burst.mean_loss - burst.good_loss) / (burst.bad_loss - burst.good_loss)) {
  // Leaving the bad state takes mean_length steps on average. In the long run as many steps go
  // from good to bad as back: share_good * good_to_bad = share_bad * bad_to_good.
  const double bad_to_good = 1 / burst.mean_length;
  good_to_bad_ = std::min(1.0, bad_to_good * bad_share_ / (1 - bad_share_));
  bad_to_bad_ = 1 - bad_to_good;
}

std::optional<bool> BurstChain::state_from_draw(std::uint64_t sequence) const {
  if (sequence % anchor == 0) return chance_.draw(Chance::Use::burst_start, sequence) < bad_share_;
  const double u = chance_.draw(Chance::Use::burst_step, sequence);
  const bool from_good = u < good_to_bad_, from_bad = u < bad_to_bad_;
  return from_good == from_bad ? std::optional(from_good) : std::nullopt;
}

bool BurstChain::is_bad(std::uint64_t sequence) {
  std::uint64_t n = sequence;
  std::optional<bool> bad;
  while (!bad) {
    if (last_ && last_->sequence == n)
      bad = last_->bad;
    else if (bad = state_from_draw(n); !bad)
      --n;
  }
  // The draws after n keep the state, or each of them changes it, when bad states avoid each other.
  if (good_to_bad_ > bad_to_bad_ && (sequence - n) % 2 == 1) bad = !*bad;
  last_ = {sequence, *bad};
  return *bad;
}

bool BurstChain::loses(std::uint64_t sequence) {
  const double loss = is_bad(sequence) ? bad_loss_ : good_loss_;
  return chance_.draw(Chance::Use::burst_loss, sequence) < loss;
}

}  // namespace arcbid
