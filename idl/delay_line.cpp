// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/delay_line.hpp"

#include <chrono>
#include <utility>

#include "core/io/process/process.hpp"

namespace arcbid {

void DelayLine::put(TimeNs at_ns, std::function<void()> deliver) {
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return;
    waiting_.emplace(at_ns, std::move(deliver));
  }
  changed_.notify_one();
}

void DelayLine::stop() {
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    waiting_.clear();
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void DelayLine::run() {
  std::unique_lock lock(mutex_);
  while (!stopped_) {
    if (waiting_.empty()) {
      changed_.wait(lock);
      continue;
    }
    const TimeNs early_ns = waiting_.begin()->first - monotonic_ns();
    if (early_ns > 0) {
      changed_.wait_for(lock, std::chrono::nanoseconds(early_ns));
      continue;
    }
    const auto next = waiting_.extract(waiting_.begin());
    lock.unlock();
    next.mapped()();
    lock.lock();
  }
}

}  // namespace arcbid
