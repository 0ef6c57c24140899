// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/batch.hpp"

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace arcbid {
namespace {

/// Hands out seeds, and takes results back in their order.
class Batch {
 public:
  Batch(std::uint64_t first, std::uint64_t last,
        const std::function<bool(const PricedResult&)>& take)
      : next_(first), last_(last), expected_(first), take_(take) {}

  /// Waits where one thread would run far ahead of the slowest.
  std::optional<std::uint64_t> next_seed() {
    std::unique_lock lock(mutex_);
    taken_.wait(lock, [this] { return stopped_ || next_ - expected_ < furthest_ahead; });
    if (stopped_ || next_ > last_) return std::nullopt;
    return next_++;
  }

  void done(PricedResult result) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t seed = result.world.seed;
    ready_.emplace(seed, std::move(result));
    while (!stopped_ && !ready_.empty() && ready_.begin()->first == expected_) {
      stopped_ = !take_(ready_.begin()->second);
      ready_.erase(ready_.begin());
      ++expected_;
    }
    taken_.notify_all();
  }

 private:
  static constexpr std::uint64_t furthest_ahead = 1000;
  std::mutex mutex_;
  std::condition_variable taken_;
  std::uint64_t next_, last_, expected_;
  const std::function<bool(const PricedResult&)>& take_;
  std::map<std::uint64_t, PricedResult> ready_;
  bool stopped_ = false;
};

}  // namespace

Worlds worlds_of(const WorldSettings& settings) {
  return {[settings](std::uint64_t seed) { return make_world(settings, seed); }, settings.price};
}

PricedResult run_priced(const Worlds& worlds, std::uint64_t seed) {
  const WorldSpec spec = worlds.make(seed);
  PricedResult result{run_world(spec), std::nullopt};
  if (worlds.price) result.fault_free = run_world(without_faults(spec));
  return result;
}

void run_batch(const Worlds& worlds, std::uint64_t first, std::uint64_t last, unsigned jobs,
               const std::function<bool(const PricedResult&)>& take) {
  Batch batch(first, last, take);
  std::vector<std::jthread> threads;
  for (unsigned n = 0; n < jobs; ++n)
    threads.emplace_back([&] {
      while (const auto seed = batch.next_seed()) batch.done(run_priced(worlds, *seed));
    });
}

}  // namespace arcbid
