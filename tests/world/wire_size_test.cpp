// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator counts bytes without knowing the wire: here its sums meet the generated code.
#include "sim/world/wire_size.hpp"

#include <gtest/gtest.h>

#include "idl/convert.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid::testing {
namespace {

template <class Message>
std::uint64_t on_the_wire(const Message& message) {
  auto sample = to_wire(message);
  return decltype(sample)::getCdrSerializedSize(sample);
}

TEST(WireSize, IsThatOfTheGeneratedCode) {
  EXPECT_EQ(wire_size(samples::bids(2)), on_the_wire(samples::bids(2)));
  EXPECT_EQ(wire_size(samples::relay(2, 3)), on_the_wire(samples::relay(2, 3)));
  EXPECT_EQ(wire_size(samples::status(2)), on_the_wire(samples::status(2)));
}

TEST(WireSize, GrowsWithEveryPart) {
  for (std::uint32_t n = 0; n < 9; ++n) {
    BidMessage bid = samples::bids(2);
    bid.statement.body = Claims{std::vector<Claim>(n)};
    EXPECT_EQ(wire_size(bid), on_the_wire(bid)) << n << " claims";
    bid.statement.body = Table{std::vector<Belief>(n), std::vector<std::uint64_t>(8 - n)};
    EXPECT_EQ(wire_size(bid), on_the_wire(bid)) << n << " beliefs";
    StatusMessage status = samples::status(2);
    status.ready.resize(n);
    status.view.resize((n * 5) % 7);
    status.heartbeats.resize((n * 3) % 8);
    EXPECT_EQ(wire_size(status), on_the_wire(status)) << n;
  }
}

}  // namespace
}  // namespace arcbid::testing
