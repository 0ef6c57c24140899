// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace arcbid {

/// Calls `work(from, to)` for fixed chunks of [0, count) on `threads` threads. Which thread takes
/// which chunk is chance: the result is the same for any number of threads as long as work writes
/// only to places that belong to its own indices. The first exception of a chunk is thrown on.
template <class Work>
void for_chunks(std::size_t count, std::size_t chunk, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::once_flag failed;
  const auto run = [&] {
    try {
      for (std::size_t from = next.fetch_add(chunk); from < count; from = next.fetch_add(chunk))
        work(from, std::min(from + chunk, count));
    } catch (...) {
      std::call_once(failed, [&] { failure = std::current_exception(); });
      next = count;
    }
  };
  std::vector<std::jthread> others;
  for (unsigned t = 1; t < threads && count > chunk; ++t) others.emplace_back(run);
  run();
  others.clear();
  if (failure) std::rethrow_exception(failure);
}

/// The number of threads for a setting where 0 stands for one a processor.
inline unsigned thread_count(unsigned asked) {
  return asked > 0 ? asked : std::clamp(std::thread::hardware_concurrency(), 1u, 16u);
}

}  // namespace arcbid
