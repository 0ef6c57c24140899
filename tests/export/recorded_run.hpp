// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include "core/auction/agent.hpp"
#include "core/io/run/agent_log.hpp"

namespace arcbid::testing {

/// A small run in virtual time that leaves logs behind as a live one does: agents on a network that
/// takes 2 ms and loses nothing, each with its log. Routes are planned when agreement is proven.
class RecordedRun {
 public:
  RecordedRun(std::filesystem::path directory, Mission mission);
  ~RecordedRun();

  void run_for(TimeNs span_ns);
  /// As kill -9 does: what was not committed is lost, and the write-ahead log stays behind.
  void kill(AgentId agent);
  void revive(AgentId agent);
  /// All that live end well.
  void end();

  std::filesystem::path log(AgentId agent) const { return members_.at(agent).file; }
  /// Hears of every step taken, committed or not.
  std::function<void(AgentId, const Step&)> watch = [](AgentId, const Step&) {};

 private:
  struct Member {
    std::unique_ptr<Agent> agent;
    std::unique_ptr<AgentLog> log;
    std::filesystem::path file;
    TimeNs wake_ns = 0;
    std::uint64_t lives = 0;
  };
  struct Delivery {
    TimeNs at_ns;
    AgentId from;
    std::variant<Tick, BidMessage, RelayMessage, StatusMessage, RoutePublished> what;
  };
  void step(AgentId id, Event event);
  void deliver(const Delivery& delivery);

  std::filesystem::path directory_;
  std::shared_ptr<const Mission> mission_;
  std::map<AgentId, Member> members_;
  std::deque<Delivery> under_way_;
  TimeNs now_ns_ = 0;
};

}  // namespace arcbid::testing
