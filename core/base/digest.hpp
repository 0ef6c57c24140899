// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace arcbid {

/// A 64-bit digest of a sequence of values: FNV-1a over 64-bit words, each mixed by the finaliser
/// of SplitMix64 (Steele, Lea, Flood 2014). Same values in the same order, same digest, on every
/// machine. Not a defence against an attacker.
class Digest {
 public:
  Digest& add(std::uint64_t word) {
    state_ = (state_ ^ mix(word)) * 0x100000001b3ULL;
    return *this;
  }
  Digest& add(double value) { return add(std::bit_cast<std::uint64_t>(value)); }
  Digest& add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    return add(std::uint64_t{text.size()});
  }
  std::uint64_t value() const { return mix(state_); }

  static constexpr std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace arcbid
