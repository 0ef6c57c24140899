// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/auction/agent.hpp"

namespace arcbid::testing {

/// A mission of `arcs` straight arcs at random in a 100 m box and `agents` UAVs at random on its
/// floor.
Mission random_mission(std::uint64_t seed, std::uint32_t agents, std::uint32_t arcs);

/// Numbers for tests: the same on every platform.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  double unit();  ///< in [0, 1)
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>(unit() * static_cast<double>(n));
  }

 private:
  std::uint64_t state_;
};

/// Agents on a network in virtual time: every message to every agent by its own draw of loss, delay
/// and duplication.
class Fleet {
 public:
  struct Link {
    double loss = 0;
    double duplicate = 0;
    TimeNs least_ns = 1'000'000, most_ns = 5'000'000;
  };
  Fleet(Mission mission, Link link, std::uint64_t seed);

  /// Runs until every living agent has a proof of one and the same view (true), or `limit_ns`
  /// passed.
  bool run(TimeNs limit_ns);
  void run_for(TimeNs span_ns);
  void kill(AgentId agent);
  void revive(AgentId agent);
  /// No message crosses between agents of different sides; an empty map heals.
  void partition(std::map<AgentId, int> sides) { sides_ = std::move(sides); }

  const Agent& agent(AgentId id) const { return *members_.at(id).agent; }
  const std::optional<Agreement>& agreement(AgentId id) const { return members_.at(id).agreement; }
  std::vector<AgentId> living() const;
  TimeNs now_ns() const { return now_ns_; }
  std::uint64_t messages() const { return messages_; }
  const Mission& mission() const { return *mission_; }

 private:
  struct Member {
    std::unique_ptr<Agent> agent;  // none: dead
    std::optional<Agreement> agreement;
    TimeNs wake_ns = 0;
    std::uint64_t lives = 0;
  };
  struct Delivery {
    TimeNs at_ns;
    std::uint64_t order;
    AgentId to;
    Event event;
  };
  void step_once();
  void carry_out(AgentId from, Update update);
  template <class Message>
  void broadcast(AgentId from, const Message& message);
  bool agreed() const;

  std::shared_ptr<const Mission> mission_;
  Link link_;
  Dice dice_;
  std::map<AgentId, Member> members_;
  std::map<AgentId, int> sides_;
  std::map<std::pair<TimeNs, std::uint64_t>, Delivery> queue_;
  TimeNs now_ns_ = 0;
  std::uint64_t order_ = 0, messages_ = 0;
};

/// The oracle: the sequential greedy allocation of `agents`, by plain search without caches. For
/// every task its winner and bid; none for what nobody has the payload or the endurance for.
std::vector<Belief> sequential_greedy(const Mission& mission, const TaskSet& set,
                                      const std::vector<AgentId>& agents);

}  // namespace arcbid::testing
