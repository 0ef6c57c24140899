// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/ids.hpp"

namespace arcbid {

/// What the launcher knows of one agent, from the events that its process reports.
struct AgentProgress {
  bool up = false, has_mission = false, started = false;
  double started_s = 0;  ///< when it passed the start barrier, since launch
  std::uint32_t round = 0;
  std::string agreed_hash;  ///< empty: no agreement, or it was reopened
  double agreed_s = 0;      ///< since launch
  std::string routed_hash;  ///< the agreement its newest route is for
  std::set<std::uint32_t> members;
  bool gone = false;  ///< its process has ended, or the others declared it dead
};

/// What a fault schedule did on one directed link.
struct LinkTraffic {
  std::uint64_t sent = 0, dropped = 0, delayed = 0, duplicated = 0;
  LinkTraffic& operator+=(const LinkTraffic& more);
};

struct Traffic {
  std::uint64_t sent = 0, received = 0, dropped = 0, bytes = 0;
};

/// Where the whole run stands. Fed with the processes' events; free of processes, clocks and files.
class Monitor {
 public:
  explicit Monitor(const std::vector<AgentId>& fleet);

  /// An event of agent `id` (0: the coordinator). Unknown events are ignored.
  void heard(std::uint32_t id, const nlohmann::json& event);
  void ended(std::uint32_t id);
  /// A process of agent `id` is started, perhaps not the first.
  void starts(std::uint32_t id);

  /// The agreement under which every living member has published its route, and its members.
  struct Outcome {
    std::string view_hash;
    std::set<std::uint32_t> members;
    std::uint32_t rounds = 0;
    double agreed_s = 0;   ///< when the last member had its proof, since launch
    double auction_s = 0;  ///< from the first member's passing the start barrier until then
  };
  std::optional<Outcome> outcome() const;

  const std::map<std::uint32_t, AgentProgress>& agents() const { return agents_; }
  Traffic traffic() const;
  /// By sender and receiver; empty when there are no faults.
  std::map<std::pair<std::uint32_t, std::uint32_t>, LinkTraffic> links() const;
  std::optional<std::size_t> arcs() const { return arcs_; }  ///< once published
  double metres() const { return metres_; }
  std::size_t tasks() const { return tasks_; }
  bool complete() const { return complete_; }         ///< the coordinator said so
  bool given_up() const { return given_up_; }         ///< the coordinator said that time is over
  std::uint64_t refused() const { return refused_; }  ///< messages that some process refused
  const std::string& first_refusal() const { return first_refusal_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::map<std::uint32_t, AgentProgress> agents_;
  using Links = std::map<std::pair<std::uint32_t, std::uint32_t>, LinkTraffic>;
  std::map<std::uint32_t, Traffic> traffic_;
  Links links_, earlier_lives_;
  std::optional<std::size_t> arcs_;
  double metres_ = 0;
  std::size_t tasks_ = 0;
  bool complete_ = false, given_up_ = false;
  std::uint64_t refused_ = 0;
  std::string first_refusal_;
  std::vector<std::string> warnings_;
};

}  // namespace arcbid
