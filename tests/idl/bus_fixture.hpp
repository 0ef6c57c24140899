// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/io/domain/domain.hpp"
#include "idl/bus.hpp"

namespace arcbid {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Real Fast DDS on 127.0.0.1, in a domain of the test's own.
class BusTest : public testing::Test {
 public:
  template <class Condition>
  static bool eventually(Condition holds, std::chrono::nanoseconds limit = 10s) {
    const auto deadline = Clock::now() + limit;
    while (!holds()) {
      if (Clock::now() > deadline) return false;
      std::this_thread::sleep_for(2ms);
    }
    return true;
  }

 protected:
  std::unique_ptr<Bus> agent(std::uint32_t id, FaultTier tier = FaultTier::messages) {
    return std::make_unique<Bus>(network_, lease_.domain(), AgentId{id}, kFleet, tier);
  }
  std::unique_ptr<Bus> coordinator() {
    return std::make_unique<Bus>(network_, lease_.domain(), the_coordinator, kFleet);
  }

  static bool matched(const Bus& bus, std::uint32_t agents) {
    return eventually([&] { return bus.matched_agents() == agents; });
  }

  /// The next message of this kind; others are passed over.
  template <class Message>
  static std::optional<Message> next(Bus& bus, std::chrono::nanoseconds limit = 10s) {
    const auto deadline = Clock::now() + limit;
    while (Clock::now() < deadline)
      for (Received& received : bus.wait(deadline - Clock::now()))
        if (auto* message = std::get_if<Message>(&received)) return std::move(*message);
    return std::nullopt;
  }

  static constexpr std::uint32_t kFleet = 16;
  NetworkConfig network_;
  DomainLease lease_{kFleet};
};

}  // namespace arcbid
