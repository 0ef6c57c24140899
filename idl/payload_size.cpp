// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/payload_size.hpp"

#include "idl/convert.hpp"

namespace arcbid {
namespace {

template <class Message>
std::uint64_t size_of(const Message& message) {
  auto sample = to_wire(message);
  return decltype(sample)::getCdrSerializedSize(sample);
}

}  // namespace

std::uint64_t payload_size(const BidMessage& message) {
  return size_of(message);
}
std::uint64_t payload_size(const RelayMessage& message) {
  return size_of(message);
}
std::uint64_t payload_size(const StatusMessage& message) {
  return size_of(message);
}

}  // namespace arcbid
