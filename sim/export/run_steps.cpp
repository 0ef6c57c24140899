// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/run_steps.hpp"

#include <algorithm>
#include <set>

namespace arcbid {
namespace {

/// Reads a log ahead, some steps at a time: a query for each would take longer than all the rest.
class Reader {
 public:
  explicit Reader(const LifeLog& life) : life_(life) {}

  struct Whole {
    Step step;
    std::string bytes;
  };
  Whole next() {
    if (ahead_.empty()) read_ahead();
    Whole whole = std::move(ahead_.front());
    ahead_.pop_front();
    return whole;
  }

 private:
  void read_ahead() {
    constexpr std::size_t steps = 256;
    life_.steps(
        [this](std::size_t mark, Step step, std::string_view bytes) {
          ahead_.push_back({std::move(step), std::string(bytes)});
          next_ = mark + 1;
          return ahead_.size() < steps;
        },
        next_);
  }

  const LifeLog& life_;
  std::size_t next_ = 0;
  std::deque<Whole> ahead_;
};

/// Owners follow from what agents state about themselves, and from who is alive.
std::set<std::size_t> turning_points(const RunArchive& run, const std::vector<Moment>& moments) {
  std::vector<std::vector<std::size_t>> when(run.lives.size());
  for (std::size_t m = 0; m < moments.size(); ++m) when[moments[m].life].push_back(m);
  std::set<std::size_t> out;
  for (std::size_t l = 0; l < run.lives.size(); ++l) {
    if (when[l].empty()) continue;
    out.insert({when[l].front() + 1, when[l].back() + 1});
    for (const auto& member : run.lives[l].learnt())
      for (const Learnt& learnt : member)
        if (learnt.is_own) out.insert(when[l][learnt.mark] + 1);
  }
  return out;
}

}  // namespace

void for_each_step(const RunArchive& run, const std::vector<Moment>& moments,
                   const std::function<void(const RunStep&)>& take) {
  std::vector<Reader> readers(run.lives.begin(), run.lives.end());
  for (std::size_t m = 0; m < moments.size(); ++m) {
    const auto [life, mark, t_ns] = moments[m];
    const Reader::Whole whole = readers[life].next();
    const LifeLog& log = run.lives[life];
    take({m, t_ns, log, log.marks()[mark], whole.step, whole.bytes});
  }
}

std::vector<Ownership> ownerships(const RunArchive& run, const Playback& playback) {
  const std::vector<Moment>& moments = playback.moments();
  std::vector<Ownership> out;
  std::vector<Belief> before(run.tasks.tasks.size());
  for (const std::size_t passed : turning_points(run, moments)) {
    std::vector<Belief> owners = playback.owners(passed);
    if (owners == before) continue;
    before = owners;
    out.push_back({passed, moments[passed - 1].t_ns, std::move(owners)});
  }
  return out;
}

}  // namespace arcbid
