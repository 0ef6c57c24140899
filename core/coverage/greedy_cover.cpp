// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/greedy_cover.hpp"

#include <algorithm>
#include <queue>

namespace arcbid {

std::vector<std::size_t> greedy_cover(const std::vector<Seen>& sets, std::size_t samples) {
  struct Entry {
    std::size_t gain, set;
    bool operator<(const Entry& other) const {
      return gain != other.gain ? gain < other.gain : set > other.set;
    }
  };
  std::priority_queue<Entry> queue;
  for (std::size_t k = 0; k < sets.size(); ++k) queue.push({sets[k].size(), k});
  std::vector<bool> held(samples);
  std::vector<std::size_t> chosen;
  while (!queue.empty()) {
    const auto [old_gain, set] = queue.top();
    queue.pop();
    const auto gain = static_cast<std::size_t>(std::count_if(
        sets[set].begin(), sets[set].end(), [&](std::uint32_t s) { return !held[s]; }));
    if (gain == 0) continue;
    // Gains only fall: one that, reckoned anew, is still the greatest is the greatest of all.
    if (gain < old_gain) {
      queue.push({gain, set});
      continue;
    }
    for (const std::uint32_t s : sets[set]) held[s] = true;
    chosen.push_back(set);
  }
  return chosen;
}

}  // namespace arcbid
