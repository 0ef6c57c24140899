// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sim/world/checkers/step.hpp"

namespace arcbid {

/// What everybody really said. Two laws: within one life the keys of an agent's statements grow
/// with every change, and one key has one content; every winning bid that anybody believes in was
/// stated by that winner.
class StatementChecker {
 public:
  StatementChecker(std::size_t tasks, Findings& findings) : tasks_(tasks), findings_(findings) {}

  void after(const SeenStep& step);

 private:
  struct Said {
    StatementKey key;
    StatementBody body;
  };
  void check_key(const SeenStep& step, const StatementKey& key, const StatementBody& body);
  void note_bids(AgentId agent, const StatementBody& body);
  bool was_bid(const Belief& belief, std::size_t task) const;

  std::size_t tasks_;
  Findings& findings_;
  std::map<std::uint32_t, Said> last_;                        // by life
  std::map<AgentId, std::vector<std::vector<double>>> bids_;  // by task
};

}  // namespace arcbid
