// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "sim/world/checkers/step.hpp"

namespace arcbid {

/// What a proof of agreement says must be so: its members are the living of V; every task has one
/// owner among them at most, and nobody more than its limit (who may have none: LimitsChecker); the
/// owner flies it and stated that very bid; and all proofs of one hash say the same.
class ProofChecker {
 public:
  ProofChecker(const Mission& mission, std::size_t tasks, Findings& findings);

  void after(const SeenStep& step);

 private:
  struct Proven {
    std::vector<AgentId> members;
    std::vector<Belief> winners;
    std::vector<NoBidder> left;
  };
  void check_members(const SeenStep& step, const Agreement& proof) const;
  void check_owners(const SeenStep& step, const Agreement& proof) const;
  void check_path(const SeenStep& step, const Agreement& proof) const;
  void check_statements(const SeenStep& step, const Agreement& proof) const;

  std::size_t tasks_, limit_;
  Findings& findings_;
  std::map<std::uint64_t, Proven> proven_;
};

/// A proof is never contradicted: a member of a proven V says nothing new unless it has heard
/// something newer than V. So the first who does must have heard of a death or a new life.
class StabilityChecker {
 public:
  explicit StabilityChecker(Findings& findings) : findings_(findings) {}

  void after(const SeenStep& step);
  /// Two processes say that they are `agent`: what one says is news to the other.
  void has_twin(AgentId agent) { twins_.push_back(agent); }

 private:
  using Keys = std::vector<StatementKey>;  // by roster position
  struct Proven {
    std::uint64_t hash;
    std::vector<bool> members;
    Keys keys;
  };
  /// An agent said something new, holding `keys` of the others.
  struct News {
    TimeNs now_ns;
    AgentId agent;
    std::size_t position;
    Keys keys;
  };
  void blame(const Proven& proven, const News& news);

  Findings& findings_;
  std::vector<Proven> proven_;
  std::vector<News> news_;
  std::vector<AgentId> twins_;
};

}  // namespace arcbid
