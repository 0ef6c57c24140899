// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "idl/guid_prefix.hpp"

/// RTPS packets made by hand, byte by byte.
namespace arcbid::packets {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t user_writer = 0x02, built_in_writer = 0xc2;

inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline Bytes header(const GuidPrefix& prefix) {
  return Bytes{'R', 'T', 'P', 'S', 2, 2, 1, 0x0f} + Bytes(prefix.begin(), prefix.end());
}

/// Little-endian; `stated` instead of the body's true length.
inline Bytes submessage(std::uint8_t kind, const Bytes& body,
                        std::optional<std::uint16_t> stated = std::nullopt) {
  const std::size_t size = stated.value_or(static_cast<std::uint16_t>(body.size()));
  return Bytes{kind, 1, static_cast<std::uint8_t>(size), static_cast<std::uint8_t>(size >> 8)} +
         body;
}

inline Bytes info_timestamp() {
  return submessage(0x09, Bytes(8));
}

/// The ids of an open reader and of a writer of this kind, and something behind them.
inline Bytes entities(std::uint8_t writer_kind) {
  return Bytes{0, 0, 0, 0, 0, 1, 2, writer_kind} + Bytes(12, 0xff);
}

inline Bytes data(std::uint8_t writer_kind) {
  return submessage(0x15, Bytes{0, 0, 16, 0} + entities(writer_kind));
}

/// What an agent's bid looks like, and an announcement of its participant.
inline Bytes bid(const GuidPrefix& prefix) {
  return header(prefix) + info_timestamp() + data(user_writer);
}
inline Bytes announcement(const GuidPrefix& prefix) {
  return header(prefix) + info_timestamp() + data(built_in_writer);
}

}  // namespace arcbid::packets
