// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/delay_line.hpp"

#include <gtest/gtest.h>

#include <future>
#include <vector>

#include "core/io/process/process.hpp"

namespace arcbid {
namespace {

constexpr TimeNs ms = 1'000'000, hour = 3'600'000 * ms;

TEST(DelayLine, DeliversInOrderOfDueTimeAndNeverEarly) {
  DelayLine line;
  std::vector<int> delivered;
  std::vector<TimeNs> at_ns;
  std::promise<void> last;
  const TimeNs now_ns = monotonic_ns();
  const auto note = [&](int number) {
    return [&, number] {
      delivered.push_back(number);
      at_ns.push_back(monotonic_ns());
      if (number == 4) last.set_value();
    };
  };
  line.put(now_ns + hour, note(9));
  line.put(now_ns + 90 * ms, note(4));
  line.put(now_ns + 60 * ms, note(2));
  line.put(now_ns + 60 * ms, note(3));
  line.put(now_ns + 30 * ms, note(1));
  last.get_future().wait();
  EXPECT_EQ(delivered, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_GE(at_ns[0], now_ns + 30 * ms);
  EXPECT_GE(at_ns[3], now_ns + 90 * ms);
}

TEST(DelayLine, ForgetsWhatWaitsWhenItStops) {
  DelayLine line;
  bool delivered = false;
  line.put(monotonic_ns() + hour, [&] { delivered = true; });
  line.stop();
  line.put(monotonic_ns(), [&] { delivered = true; });
  line.stop();
  EXPECT_FALSE(delivered);
}

TEST(DelayLine, StopsOnlyAfterWhatIsBeingDelivered) {
  DelayLine line;
  std::promise<void> begun;
  bool ended = false;
  line.put(monotonic_ns(), [&] {
    begun.set_value();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ended = true;
  });
  begun.get_future().wait();
  line.stop();
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace arcbid
