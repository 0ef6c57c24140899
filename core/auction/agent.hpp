// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/auction/bid_audit.hpp"
#include "core/auction/dissemination.hpp"
#include "core/auction/membership.hpp"
#include "core/auction/message.hpp"
#include "core/auction/no_bidders.hpp"
#include "core/auction/policy.hpp"
#include "core/auction/readiness.hpp"
#include "core/auction/task_set.hpp"
#include "core/auction/validation.hpp"
#include "core/auction/view.hpp"

namespace arcbid {

/// Time passed. `matched_peers`: how many other agents the transport reaches in both directions.
struct Tick {
  std::uint32_t matched_peers = 0;
};

/// The route for the agreement `view_hash` was published.
struct RoutePublished {
  std::uint64_t view_hash = 0;
};

/// Everything an agent can learn. Times never go back within one life.
struct Event {
  TimeNs now_ns = 0;
  std::variant<Tick, BidMessage, RelayMessage, StatusMessage, RoutePublished> what;
};

/// One round: what the agent decided on the view it holds.
struct DecisionMade {
  std::uint32_t round = 0;
  bool changed = false;
  StatementKey key;            ///< under which the result is stated
  StatementBody body;          ///< the statement itself: b_i, or y_i and z_i
  std::vector<PathStop> path;  ///< p_i
};

/// What one member won: claims in the order in which it took them, from which its path follows; of
/// tables, which do not say it, by falling bids.
struct Taken {
  AgentId agent;
  std::vector<TaskId> tasks;
};

/// Proof that every living member holds the same allocation and will not change it by itself.
struct Agreement {
  std::uint64_t view_hash = 0;   ///< H: the same for every member
  std::uint32_t round = 0;       ///< decisions this agent made until then
  std::vector<AgentId> members;  ///< the living
  std::vector<Belief> winners;   ///< z and y, an entry for each task
  std::vector<PathStop> path;    ///< p_i of this agent
  std::vector<Taken> taken;      ///< by all members
  std::vector<NoBidder> left;    ///< what none of the members flies, and why
};

/// What the caller must carry out, in the order of the fields.
struct Update {
  std::vector<BidMessage> bids;         ///< send to all
  std::vector<RelayMessage> relays;     ///< send to all
  std::vector<StatusMessage> statuses;  ///< send to all
  std::optional<std::string>
      refused;                    ///< the event was a message that was refused: count and report
  std::vector<AgentId> died;      ///< declared dead just now: their tasks are free again
  std::vector<AgentId> returned;  ///< known as dead, now alive in a new life
  std::optional<DecisionMade> decision;
  bool started = false;             ///< the start barrier was passed just now
  bool agreement_lost = false;      ///< something outside changed: routes so far are void
  std::optional<Agreement> agreed;  ///< proven just now: plan, publish, then say RoutePublished
  TimeNs wake_ns = 0;               ///< step with a Tick no later than this
};

/// One agent of the auction, as a pure state machine: events in, updates out, nothing else. The
/// live process, a simulator, a replay and the tests run this same class.
class Agent {
 public:
  /// `incarnation` must differ between lives of one agent and grow (the wall clock in ms at birth,
  /// never 1). `self` must be in the mission's fleet.
  Agent(AgentId self, std::uint64_t incarnation, std::shared_ptr<const Mission> mission,
        std::shared_ptr<const Transit> transit, TimeNs now_ns);

  Update step(const Event& event);

  Phase phase() const { return phase_; }
  const TaskSet& tasks() const { return tasks_; }
  const View& view() const { return view_; }
  std::vector<Belief> winners() const { return policy_->winners(view_); }

 private:
  void handle(const Tick& tick, Update& update);
  void handle(const BidMessage& bid, Update& update);
  void handle(const RelayMessage& relay, Update& update);
  void handle(const StatusMessage& status, Update& update);
  void handle(const RoutePublished& route, Update& update);

  std::optional<std::size_t> accept(const Header& header, Update& update);
  void learn(const Statement& statement, Update& update);
  void view_changed(std::size_t member, Update& update);
  void refute(const StatementKey& claimed, Update& update);
  void start_if_everybody_is_here(Update& update);
  void bury_the_silent(Update& update);
  bool round_is_over() const;
  bool round_is_reported(const Update& update) const;
  void decide(Update& update);
  void decided(bool changed, Update& update);
  void state(std::uint32_t version);
  void prove(Update& update);
  Taken taken_by(AgentId agent, const std::vector<Belief>& winners) const;
  std::vector<NoBidder> left_over(const Agreement& agreement) const;
  void send(Update& update);
  StatusMessage status(bool whole) const;
  void tell_what_is_held(StatusMessage& status) const;
  void hear_what_is_held(std::size_t k, const StatusMessage& status, Update& update);
  Header header();
  TimeNs next_wake() const;
  bool everybody_is_here() const;

  const AgentId self_;
  std::uint64_t incarnation_;
  const std::shared_ptr<const Mission> mission_;
  const std::shared_ptr<const Transit> transit_;
  const TaskSet tasks_;
  View view_;
  const std::size_t me_;  // roster position of self
  const Expected expected_;
  BidAudit audit_;
  std::unique_ptr<Policy> policy_;
  Membership membership_;
  Readiness readiness_;
  Dissemination dissemination_;

  TimeNs now_ns_;
  const TimeNs born_ns_;
  Phase phase_ = Phase::waiting_for_peers;
  std::vector<bool> present_;   // members that passed, or stand at, the barrier
  bool auction_is_on_ = false;  // somebody started already
  std::uint32_t matched_peers_ = 0;
  std::uint64_t sequence_ = 0;
  std::uint32_t round_ = 0;
  bool is_prepared_ = false;  // the first statement is a decision already
  bool undecided_ = true;     // the view changed since the last decision
  TimeNs decided_ns_;
  std::optional<TimeNs> refuted_ns_;
  bool round_was_told_ = false;                  // by a status, since the last decision
  std::vector<std::optional<TimeNs>> spoke_ns_;  // when each member was last heard directly
  std::uint64_t view_hash_ = 0;
  bool status_is_news_ = true;
  TimeNs status_sent_ns_;
  TimeNs whole_sent_ns_;
  std::vector<StatementKey> said_keys_;  // in the last whole status, by roster position
  std::vector<Heartbeat> said_heartbeats_;
};

}  // namespace arcbid
