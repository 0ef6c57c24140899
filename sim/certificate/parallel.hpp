// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace arcbid::certificate {

/// Calls `work(first, last)` for fixed chunks of 0 .. count on so many threads (0: as many as there
/// are processors). What a chunk does must depend on it alone: then the result is the same whatever
/// the number of threads. The first exception of a chunk is thrown on.
template <class Work>
void in_chunks(std::size_t count, std::size_t chunk, unsigned threads, const Work& work) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto run = [&] {
    try {
      for (std::size_t first = next.fetch_add(chunk); first < count; first = next.fetch_add(chunk))
        work(first, std::min(count, first + chunk));
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::jthread> others;
  for (unsigned t = 1; t < threads && t * chunk < count; ++t) others.emplace_back(run);
  run();
  others.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace arcbid::certificate
