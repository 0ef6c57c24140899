// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/dice.hpp"

#include "core/base/digest.hpp"

namespace arcbid {

/// The quantiles -ln((2k + 1) / 8192), by ln(m + 1) - ln(m - 1) = 2 artanh(1 / m), from m = 2 on.
TradeDice::TradeDice(std::uint64_t seed) : state_(seed) {
  constexpr double ln_8192 = 9.0109133472792885;
  double ln = 0;
  for (std::size_t k = 0; k < deviates_.size(); ++k) {
    deviates_[k] = ln_8192 - ln;
    const double x = 1 / static_cast<double>(2 * k + 2), square = x * x;
    double term = x, artanh = 0;
    for (int odd = 1; odd < 40; odd += 2, term *= square) artanh += term / odd;
    ln += 2 * artanh;
  }
}

std::uint64_t TradeDice::next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  return Digest::mix(state_);
}

}  // namespace arcbid
