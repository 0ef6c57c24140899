// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "core/base/ids.hpp"

namespace arcbid {

/// Does things later, on a thread of its own, in the order in which they are due; what is due at
/// the same time, in the order in which it came. Times are of the monotonic clock.
class DelayLine {
 public:
  DelayLine() : thread_([this] { run(); }) {}
  ~DelayLine() { stop(); }

  /// After stop() this does nothing.
  void put(TimeNs at_ns, std::function<void()> deliver);

  /// Forgets what waits. When this returns nothing is being delivered, and nothing will be. Not to
  /// be called by what is delivered, nor by two threads at once.
  void stop();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::multimap<TimeNs, std::function<void()>> waiting_;
  bool stopped_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace arcbid
