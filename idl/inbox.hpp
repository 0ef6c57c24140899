// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include "idl/bus.hpp"

namespace arcbid {

/// What DDS threads leave and one thread takes, in order of arrival.
class Inbox {
 public:
  /// False when it is full of what an owner that stands still has not taken. Only what may get lost
  /// on the way as well is refused then: an `expendable` message.
  bool put(Received message, bool expendable) {
    {
      const std::scoped_lock lock(mutex_);
      if (expendable && messages_.size() >= kCapacity) return false;
      messages_.push_back(std::move(message));
    }
    arrived_.notify_one();
    return true;
  }

  /// Everything there is; waits up to `timeout` for the first message or a wake().
  std::vector<Received> take(std::chrono::nanoseconds timeout) {
    std::unique_lock lock(mutex_);
    // Half a century is for ever, and does not overflow the clock.
    arrived_.wait_for(lock, std::min<std::chrono::nanoseconds>(timeout, std::chrono::years(50)),
                      [this] { return woken_ || !messages_.empty(); });
    woken_ = false;
    return std::exchange(messages_, {});
  }

  void wake() {
    {
      const std::scoped_lock lock(mutex_);
      woken_ = true;
    }
    arrived_.notify_one();
  }

 private:
  static constexpr std::size_t kCapacity = 65'536;
  std::mutex mutex_;
  std::condition_variable arrived_;
  bool woken_ = false;
  std::vector<Received> messages_;
};

}  // namespace arcbid
