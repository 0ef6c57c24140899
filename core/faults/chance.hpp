// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/digest.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// The chance of one fault on one directed link: numbers in [0, 1) that are a hash of the
/// schedule's seed, the fault's index, the link, the message's sequence number and what the number
/// is for. Nothing else has a say, so that the same message meets the same fate in every run.
class Chance {
 public:
  /// What a number is for. The values are part of every seed's meaning.
  enum class Use : std::uint8_t {
    loss,
    burst_step,
    burst_start,
    burst_loss,
    reach,
    delay,
    duplicate,
    duplicate_delay,
    stale
  };

  Chance(std::uint64_t seed, std::uint64_t fault, AgentId from, AgentId to) {
    link_.add(seed).add(fault).add(std::uint64_t{from.value}).add(std::uint64_t{to.value});
  }

  /// Uniform in [0, 1), 53 bits. `copy` tells apart several copies of one message.
  double draw(Use use, std::uint64_t sequence, std::uint64_t copy = 0) const {
    const std::uint64_t bits =
        Digest(link_).add(static_cast<std::uint64_t>(use)).add(sequence).add(copy).value();
    return static_cast<double>(bits >> 11) * 0x1p-53;
  }

 private:
  Digest link_;
};

}  // namespace arcbid
