// SPDX-License-Identifier: GPL-3.0-or-later
// Every decoder against payloads that were damaged at random: none may throw, hang or take what it
// could not say itself.
#include <gtest/gtest.h>

#include "core/base/digest.hpp"
#include "idl/convert.hpp"
#include "idl/endpoint.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  std::uint64_t below(std::uint64_t n) { return Digest::mix(++state_) % n; }

 private:
  std::uint64_t state_;
};

/// A few bytes changed, a length made huge, the end cut off, or a stretch repeated.
std::vector<std::uint8_t> damaged(std::vector<std::uint8_t> bytes, Chance& chance) {
  const std::uint64_t wounds = 1 + chance.below(4);
  for (std::uint64_t n = 0; n < wounds && bytes.size() > 8; ++n) {
    const std::size_t at = chance.below(bytes.size());
    switch (chance.below(4)) {
      case 0:
        bytes[at] = static_cast<std::uint8_t>(chance.below(256));
        break;
      case 1:
        for (std::size_t b = at & ~std::size_t{3};
             b < std::min(bytes.size(), (at & ~std::size_t{3}) + 4); ++b)
          bytes[b] = 0xff;
        break;
      case 2:
        bytes.resize(at + 1);
        break;
      default:
        bytes.insert(bytes.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end());
    }
  }
  return bytes;
}

template <class Message>
void survives(const Message& message) {
  using Type = GuardedType<typename Topic<Message>::Type>;
  Type type;
  auto sound = to_wire(message);
  SerializedPayload_t whole(static_cast<std::uint32_t>(type.getSerializedSizeProvider(&sound)()));
  ASSERT_TRUE(type.serialize(&sound, &whole));
  const std::vector<std::uint8_t> bytes(whole.data, whole.data + whole.length);
  Chance chance(7);
  std::size_t taken = 0, refused = 0;
  for (int round = 0; round < 20000; ++round) {
    const auto bad = damaged(bytes, chance);
    SerializedPayload_t payload(static_cast<std::uint32_t>(bad.size()));
    std::copy(bad.begin(), bad.end(), payload.data);
    payload.length = static_cast<std::uint32_t>(bad.size());
    typename Type::Sample sample;
    ASSERT_NO_THROW(type.deserialize(&payload, &sample));
    ASSERT_NO_THROW({
      const auto decoded = from_wire(sample);
      if (std::holds_alternative<Message>(decoded)) {
        ++taken;
        to_wire(std::get<Message>(decoded));
      } else {
        ++refused;
      }
    });
  }
  EXPECT_GT(refused, 1000u);
  EXPECT_GT(taken + refused, 0u);
}

TEST(FuzzedDecoders, SurviveMissions) {
  survives(samples::mission());
}
TEST(FuzzedDecoders, SurviveControl) {
  survives(samples::control());
}
TEST(FuzzedDecoders, SurviveBids) {
  survives(samples::bids(2));
}
TEST(FuzzedDecoders, SurviveRelays) {
  survives(samples::relay(2, 3));
}
TEST(FuzzedDecoders, SurviveStatus) {
  survives(samples::status(2));
}
TEST(FuzzedDecoders, SurviveRoutes) {
  survives(samples::route(2));
}

}  // namespace
}  // namespace arcbid
