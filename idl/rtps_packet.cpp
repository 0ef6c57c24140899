// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/rtps_packet.hpp"

#include <algorithm>
#include <string_view>

namespace arcbid {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::string_view protocol = "RTPS";
constexpr std::size_t prefix_at = 8, header_size = 20, submessage_header_size = 4;
constexpr std::uint8_t little_endian_flag = 0x01;
constexpr std::uint8_t built_in_kind = 0xc0;  // the two upper bits of an entity id's last byte

enum SubmessageKind : std::uint8_t {
  pad = 0x01,
  acknack = 0x06,
  heartbeat = 0x07,
  gap = 0x08,
  info_timestamp = 0x09,
  nack_frag = 0x12,
  heartbeat_frag = 0x13,
  data = 0x15,
  data_frag = 0x16,
};

/// Where, in a submessage's body, the reader's and then the writer's entity id stand.
std::optional<std::size_t> entity_ids_at(std::uint8_t kind) {
  switch (kind) {
    case data:
    case data_frag:
      return 4;  // behind the extra flags and the offset of inline QoS
    case acknack:
    case heartbeat:
    case gap:
    case nack_frag:
    case heartbeat_frag:
      return 0;
    default:
      return std::nullopt;
  }
}

/// The writer's id says it: a reader's may be left open.
bool writer_is_built_in(std::uint8_t kind, Bytes body) {
  const auto at = entity_ids_at(kind);
  constexpr std::size_t writer_kind = 7;
  if (!at || body.size() <= *at + writer_kind) return false;
  return (body[*at + writer_kind] & built_in_kind) == built_in_kind;
}

/// How much of `rest`, what follows a submessage's header, is its body.
std::size_t body_size(std::uint8_t kind, std::uint8_t flags, std::size_t first, std::size_t second,
                      std::size_t rest) {
  const std::size_t stated =
      (flags & little_endian_flag) != 0 ? first | second << 8 : first << 8 | second;
  // A length of 0 means up to the packet's end, but for the two kinds that may be empty.
  if (stated == 0 && kind != pad && kind != info_timestamp) return rest;
  return std::min(stated, rest);
}

}  // namespace

std::optional<GuidPrefix> sender_of(Bytes packet) {
  if (packet.size() < header_size ||
      !std::equal(protocol.begin(), protocol.end(), packet.begin()))
    return std::nullopt;
  GuidPrefix prefix;
  std::copy_n(packet.begin() + prefix_at, prefix.size(), prefix.begin());
  return prefix;
}

bool is_discovery(Bytes packet) {
  Bytes rest = packet.subspan(std::min(packet.size(), header_size));
  while (rest.size() >= submessage_header_size) {
    const std::uint8_t kind = rest[0], flags = rest[1], first = rest[2], second = rest[3];
    rest = rest.subspan(submessage_header_size);
    const std::size_t size = body_size(kind, flags, first, second, rest.size());
    if (writer_is_built_in(kind, rest.first(size))) return true;
    rest = rest.subspan(size);
  }
  return false;
}

}  // namespace arcbid
