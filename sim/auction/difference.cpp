// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/difference.hpp"

#include <algorithm>

#include "sim/auction/protocol.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t place_bytes = 2, kept_bytes = 2;

}  // namespace

std::uint64_t Difference::bytes() const {
  std::uint64_t bytes = kept_bytes;
  for (const Entry& entry : entries)
    bytes += std::holds_alternative<Claim>(entry) ? claim_bytes : place_bytes;
  return bytes;
}

Difference difference(const std::vector<Claim>& before, const std::vector<Claim>& now) {
  const auto same = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
  Difference out{static_cast<std::uint16_t>(same.second - now.begin()), {}};
  for (auto claim = same.second; claim != now.end(); ++claim) {
    const auto found = std::find(same.first, before.end(), *claim);
    if (found == before.end())
      out.entries.emplace_back(*claim);
    else
      out.entries.emplace_back(static_cast<std::uint16_t>(found - before.begin()));
  }
  return out;
}

std::vector<Claim> restored(const Difference& difference, const std::vector<Claim>& before) {
  std::vector<Claim> now(before.begin(), before.begin() + difference.kept);
  for (const Difference::Entry& entry : difference.entries) {
    const auto* claim = std::get_if<Claim>(&entry);
    now.push_back(claim ? *claim : before[std::get<std::uint16_t>(entry)]);
  }
  return now;
}

}  // namespace arcbid
