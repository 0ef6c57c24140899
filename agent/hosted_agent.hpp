// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "agent/faulty_links.hpp"
#include "agent/malformer.hpp"
#include "agent/route_planner.hpp"
#include "agent/shared_bus.hpp"
#include "core/auction/agent.hpp"
#include "core/faults/schedule.hpp"
#include "core/faults/tier.hpp"
#include "core/io/process/process.hpp"
#include "core/io/run/agent_log.hpp"

namespace arcbid {

struct AgentOptions {
  AgentId id;
  std::optional<std::filesystem::path> run;  ///< run directory; none: no files are written
  std::optional<FaultSchedule> faults;       ///< what goes wrong on the way to this agent
  FaultTier fault_tier = FaultTier::messages;
  TimeNs epoch_ns = 0;  ///< launch, on the monotonic clock
  bool json_events = false;
};

/// One UAV: carries events from the bus and the clock into the auction's state machine, and its
/// updates out to the bus, to the log and to whoever started it. Decides nothing itself.
class HostedAgent {
 public:
  HostedAgent(AgentOptions options, SharedBus& bus);

  /// Does what is due: hears what has arrived, steps, publishes, plans.
  void turn();
  /// How long until something is due that nothing announces.
  TimeNs wait_ns() const;
  /// Set when the coordinator has ended the mission.
  std::optional<Exit> done() const { return done_; }
  /// The last report and record, when the process is about to end.
  void finish();

 private:
  void handle(const Mission& mission);
  void handle(const ControlMessage& control);
  void handle(const Malformed& malformed);
  void handle(const RouteMessage&) {}  // the other agents' routes are the coordinator's business
  template <class Message>
  void handle(const Message& message);

  void step(Event event);
  void install_faults();
  void hear_what_is_due();
  void say_what_is_malformed();
  void report_links(bool last);
  void release(const std::vector<AgentId>& dead);
  /// What this agent's own clock shows: the auction knows no other.
  TimeNs clock_ns() const;
  void carry_out(Update& update);
  void report(const Update& update);
  void report_round(const DecisionMade& decision);
  void start_planning();
  void fly_if_planned();
  void publish(const Agreement& agreement, const PlannedFlight& flight);
  void tell_exchanges(const Agreement& agreement, const Share& share);
  std::optional<std::filesystem::path> log_file() const;
  void refuse(const std::string& reason);
  void meet_namesake(const Header& header);
  void ask_for_mission();
  void report_traffic(bool last);
  TimeNs now_ns() const { return monotonic_ns() - options_.epoch_ns; }

  AgentOptions options_;
  SharedBus& bus_;
  Reporter report_;
  const std::uint64_t incarnation_;
  AgentLog log_;
  std::shared_ptr<const Mission> mission_;
  std::shared_ptr<const Transit> transit_;
  std::unique_ptr<Agent> agent_;        // once the mission is known
  std::optional<FaultyLinks> links_;    // likewise, when there are faults of messages
  std::optional<Malformer> malformer_;  // likewise, when there are faults
  std::uint64_t mission_digest_ = 0;
  std::vector<Belief> winners_;       // as of the last decision: what the dead had won
  std::optional<Agreement> to_plan_;  // the newest agreement, until its route is published
  double agreed_s_ = 0;
  RoutePlanner planner_;  // after agent_, whose tasks it reads
  TimeNs wake_ns_ = 0;
  TimeNs traffic_reported_ns_ = 0;
  TimeNs round_reported_ns_ = 0;
  std::uint64_t refused_ = 0;
  int elder_messages_ = 0;      // of a process with this id that has said more
  std::uint64_t sequence_ = 0;  // of status messages before the mission
  std::optional<Exit> done_;
  std::string_view ended_by_ = "signal";
};

}  // namespace arcbid
