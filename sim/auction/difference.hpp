// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/auction/message.hpp"

namespace arcbid {

/// A bundle as the difference to an earlier one, for links on which nothing is lost: a claim that
/// stood in the earlier one is named by its place there, two bytes instead of ten.
struct Difference {
  using Entry = std::variant<std::uint16_t, Claim>;
  std::uint16_t kept = 0;      ///< so many claims from the first on are the same
  std::vector<Entry> entries;  ///< the rest, in bundle order

  std::uint64_t bytes() const;
};

Difference difference(const std::vector<Claim>& before, const std::vector<Claim>& now);
std::vector<Claim> restored(const Difference& difference, const std::vector<Claim>& before);

}  // namespace arcbid
