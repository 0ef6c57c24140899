// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <tuple>

#include "core/auction/acbba.hpp"
#include "sim/auction/protocol.hpp"

namespace arcbid {
namespace {

/// Only what the table says is worth saying: changed beliefs, and rebroadcasts.
class AcbbaRounds final : public RoundsProtocol {
 public:
  explicit AcbbaRounds(const RoundsWorld& world) : world_(world), saying_(world.agents()) {
    for (const Uav& uav : world.instance.fleet)
      agents_.emplace_back(uav.id,
                           make_bundle(world.instance.tasks, uav, world.settings, world.transit),
                           world.tasks());
  }

  bool play(Traffic& traffic) override {
    bool changed = false;
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      const std::vector<TaskId> mine = agents_[i].rebid();
      changed |= !mine.empty();
      saying_[i].insert(mine.begin(), mine.end());
    }
    std::vector<std::vector<Said>> said(agents_.size());
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      for (const TaskId j : saying_[i]) said[i].push_back({j, agents_[i].belief(j)});
      count(i, said[i].size(), traffic);
      saying_[i].clear();
    }
    for (std::size_t i = 0; i < agents_.size(); ++i)
      for (const std::size_t k : world_.neighbours[i])
        for (const Said& what : said[k]) changed |= hear(i, k, what);
    return changed;
  }

  bool agreed() const override {
    return std::all_of(agents_.begin(), agents_.end(), [&](const AcbbaState& agent) {
      return agent.table().beliefs == agents_.front().table().beliefs;
    });
  }

  std::vector<std::vector<PathStop>> paths() const override {
    std::vector<std::vector<PathStop>> paths;
    for (const AcbbaState& agent : agents_) paths.push_back(agent.bundle().path());
    return paths;
  }

 private:
  struct Said {
    TaskId task;
    TimedBelief what;
  };

  void count(std::size_t i, std::size_t beliefs, Traffic& traffic) const {
    if (beliefs == 0) return;
    traffic.messages += world_.neighbours[i].size();
    traffic.sends += 1;
    traffic.bytes += message_bytes + timed_belief_bytes * beliefs;
    traffic.difference_bytes = traffic.bytes;  // it says nothing else anyway
  }

  bool hear(std::size_t i, std::size_t k, const Said& said) {
    const Belief before = agents_[i].belief(said.task).belief;
    const Rebroadcast say = agents_[i].receive(world_.instance.fleet[k].id, said.task, said.what);
    if (say != Rebroadcast::nothing) saying_[i].insert(said.task);
    return agents_[i].belief(said.task).belief != before;
  }

  const RoundsWorld& world_;
  std::vector<AcbbaState> agents_;
  std::vector<std::set<TaskId>> saying_;  // by agent: what it will say next
};

}  // namespace

std::unique_ptr<RoundsProtocol> acbba_rounds(const RoundsWorld& world) {
  return std::make_unique<AcbbaRounds>(world);
}

}  // namespace arcbid
