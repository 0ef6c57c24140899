// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/auction/agent.hpp"
#include "core/base/digest.hpp"
#include "sim/world/checkers/checkers.hpp"
#include "sim/world/checkers/exchanges.hpp"
#include "sim/world/checkers/greedy.hpp"
#include "sim/world/fleet_graph.hpp"
#include "sim/world/network.hpp"
#include "sim/world/run.hpp"
#include "sim/world/script.hpp"

namespace arcbid {

/// One world while it runs. Everything in it happens in virtual time and in one order.
class World {
 public:
  World(const WorldSpec& spec, const Trace& trace, WorldObserver* observer);

  WorldResult run();

 private:
  /// Messages still to be spoilt, and how.
  struct Spoiling {
    Malformation how = Malformation::nan_bid;
    std::uint32_t left = 0;
  };
  /// One process: an agent from its birth to its death.
  struct Life {
    std::size_t agent = 0;  // position in the fleet
    std::uint32_t number = 0;
    std::unique_ptr<Agent> core;
    TimeNs wake_ns = 0;
    bool is_twin = false;
    bool is_paused = false;
    std::vector<Delivery> inbox;  // what came during a pause
    std::optional<Agreement> proof;
    bool is_routed = true;            // the route for the proof was published
    std::vector<Claim> bundle;        // as last decided
    std::optional<BidMessage> said;   // the last statement sent
    std::vector<BidMessage> history;  // the first ones, to be replayed
    std::vector<Spoiling> spoilings;  // begun, and not yet all said
  };

  // world.cpp: what happens next
  bool next();
  Life* first_to_wake();
  void wake(Life& life);
  void deliver(const Delivery& delivery);
  void hear(Life& life, const Delivery& delivery);
  void tell_fate(const Delivery& message, const Fate& fate) const;
  void step(Life& life, const Event& event);
  void carry_out(Life& life, Update& update);
  void check_refusal(const Life& life, const Delivery& delivery, const Update& update,
                     const std::vector<StatementKey>& before);
  TimeNs clock_ns(std::size_t agent) const;
  void remember(const Life& life, const Update& update);
  std::uint32_t matched_peers(const Life& life) const;

  // world_acts.cpp: what happens to processes
  void act(const Act& act);
  void start(std::size_t agent, bool is_twin);
  void stop(std::size_t agent, bool twins);
  void resume(std::size_t agent);
  void bid_over(const Act& act);
  void say_something_bad(Life& life, Spoiling& spoiling);
  std::vector<Life*> lives_of(std::size_t agent);

  // world_end.cpp: whether it is over, and what came of it
  bool has_agreed();
  TimeNs deadline_ns() const;
  TimeNs bound_ns() const;
  TimeNs bound_ns(std::size_t diameter) const;
  std::uint64_t most_steps() const;
  std::vector<Component> living_components() const;
  double fly(const Component& component, std::size_t n, const Bidder& bidder,
             std::vector<Piece>& flown);
  void work_out_exchanges(const Life& life, const Agreement& proof);
  void check_outcome(const std::vector<Component>& components);
  std::vector<Bidder> bidders(const Component& component) const;
  const Life& life_of(std::size_t agent) const;
  void tell_that_it_does_not_end();
  WorldResult result();

  template <class... T>
  void trace(fmt::format_string<T...> format, T&&... values) const {
    if (trace_)
      trace_(fmt::format("{:10.3f} ms  ", static_cast<double>(now_ns_) * 1e-6) +
             fmt::format(format, std::forward<T>(values)...));
  }

  const WorldSpec& spec_;
  const Trace& trace_;
  WorldObserver* const observer_;  // null: nobody
  std::shared_ptr<const Mission> mission_;
  std::shared_ptr<const Transit> transit_;
  std::vector<Stretch> pieces_;
  Network network_;
  std::vector<Act> script_;
  std::size_t acts_done_ = 0;
  std::vector<bool> has_clock_fault_;
  std::vector<Life> lives_;  // the living, in the order of their births
  std::uint32_t births_ = 0;
  Checkers checkers_;
  ExchangeChecker exchange_checker_;
  std::map<std::uint64_t, FleetShare> exchanged_;  // by view hash, where there are exchanges
  TimeNs now_ns_ = 0, calm_ns_, last_turn_ns_, bound_ns_ = 0;
  bool may_have_agreed_ = false;  // something changed since has_agreed() was asked
  WorldResult result_;
  Digest digest_;
};

}  // namespace arcbid
