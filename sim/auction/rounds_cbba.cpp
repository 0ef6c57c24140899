// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/auction/cbba.hpp"
#include "sim/auction/protocol.hpp"

namespace arcbid {
namespace {

/// Whole tables to every neighbour in every round, as published.
class CbbaRounds final : public RoundsProtocol {
 public:
  explicit CbbaRounds(const RoundsWorld& world) : world_(world) {
    const bool rebuilds = world.settings.policy == PolicyKind::cbba_rebuild;
    for (const Uav& uav : world.instance.fleet)
      agents_.emplace_back(uav.id, world.roster(),
                           make_bundle(world.instance.tasks, uav, world.settings, world.transit),
                           world.tasks(), rebuilds);
    said_.resize(agents_.size());
  }

  bool play(Traffic& traffic) override {
    ++round_;
    bool changed = false;
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      changed |= agents_[i].bid();
      const std::size_t news = changes(said_[i].beliefs, agents_[i].table().beliefs);
      traffic.difference_bytes +=
          message_bytes + changed_belief_bytes * news + timestamp_bytes * agents_.size();
      said_[i] = agents_[i].table();
    }
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      const auto& neighbours = world_.neighbours[i];
      for (const std::size_t k : neighbours) changed |= agents_[i].receive(k, said_[k], round_);
      traffic.messages += neighbours.size();
      traffic.sends += 1;
      agents_[i].release();
      traffic.bytes +=
          message_bytes + claim_bytes * world_.tasks() + timestamp_bytes * agents_.size();
    }
    return changed;
  }

  bool agreed() const override {
    return std::all_of(agents_.begin(), agents_.end(), [&](const CbbaState& agent) {
      return agent.table().beliefs == agents_.front().table().beliefs;
    });
  }

  std::vector<std::vector<PathStop>> paths() const override {
    std::vector<std::vector<PathStop>> paths;
    for (const CbbaState& agent : agents_) paths.push_back(agent.bundle().path());
    return paths;
  }

 private:
  static std::size_t changes(const std::vector<Belief>& before, const std::vector<Belief>& now) {
    if (before.empty())
      return now.size() - static_cast<std::size_t>(std::count(now.begin(), now.end(), Belief{}));
    std::size_t changed = 0;
    for (std::size_t j = 0; j < now.size(); ++j) changed += now[j] != before[j];
    return changed;
  }

  const RoundsWorld& world_;
  std::vector<CbbaState> agents_;
  std::vector<Table> said_;
  std::uint64_t round_ = 0;
};

}  // namespace

std::unique_ptr<RoundsProtocol> cbba_rounds(const RoundsWorld& world) {
  return std::make_unique<CbbaRounds>(world);
}

}  // namespace arcbid
