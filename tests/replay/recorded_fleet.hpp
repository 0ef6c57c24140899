// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "core/auction/agent.hpp"
#include "core/io/run/agent_log.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid::testing {

/// A fleet in virtual time that leaves a run directory's logs behind, as processes do.
class RecordedFleet {
 public:
  /// Every message takes 1 to 5 ms and `loss` of them are lost, by the seed.
  RecordedFleet(Mission mission, std::filesystem::path directory, std::uint64_t seed,
                double loss = 0);

  /// From now on the host of `agent` counts its log's times from so much later.
  void set_clock(AgentId agent, TimeNs offset_ns) { clocks_[agent] = offset_ns; }
  /// SIGKILL: its log ends without a word.
  void kill(AgentId agent) { members_.erase(agent); }
  void revive(AgentId agent);
  /// Until all that live have proven the same, or `limit_ns` have passed.
  bool run(TimeNs limit_ns);
  void run_for(TimeNs span_ns);
  void step_once();
  /// The coordinator ends the mission for all that live.
  void end();

  /// Keeps Agent::winners() after every step, by agent.
  void keep_winners() { keeps_winners_ = true; }
  const std::map<AgentId, std::vector<std::vector<Belief>>>& winners() const { return winners_; }
  const Agent& agent(AgentId id) const { return *members_.at(id).agent; }
  TimeNs now_ns() const { return now_ns_; }
  std::uint64_t steps() const { return steps_; }

 private:
  struct Member {
    std::unique_ptr<Agent> agent;
    std::unique_ptr<AgentLog> log;
    std::optional<Agreement> agreement;
    TimeNs wake_ns = 0;
  };
  struct Delivery {
    AgentId to;
    Event event;
  };
  void step(AgentId id, Event event);
  template <class Message>
  void broadcast(AgentId from, const Message& message);
  bool agreed() const;
  TimeNs shown_ns(AgentId agent) const;

  std::shared_ptr<const Mission> mission_;
  std::filesystem::path directory_;
  Dice dice_;
  double loss_;
  std::map<AgentId, Member> members_;  // the living
  std::map<AgentId, TimeNs> clocks_;
  std::map<std::pair<TimeNs, std::uint64_t>, Delivery> queue_;
  std::map<AgentId, std::vector<std::vector<Belief>>> winners_;
  bool keeps_winners_ = false;
  TimeNs now_ns_ = 0;
  std::uint64_t order_ = 0, steps_ = 0;
};

/// A folder that is gone with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace arcbid::testing
