// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/arcs/airspace.hpp"
#include "core/arcs/arc.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// One UAV of the fleet.
struct Uav {
  AgentId id;
  Vec3 home_m = Vec3::Zero();
  double speed_mps = 1.0;
  std::optional<double> endurance_s =
      std::nullopt;                ///< longest flight, home to home; none: no limit
  Payload payload = Payload::any;  ///< what it carries
};

/// How the fleet comes to agree; core/auction/policy.hpp says what each does.
enum class PolicyKind : std::uint8_t { claims, claims_keep, cbba, cbba_rebuild, acbba };

/// What a task is worth to an agent; core/auction/score.hpp says how each is computed.
enum class ScoreKind : std::uint8_t {
  minimax,
  minisum,
  independent,
  discounted_append,
  discounted_insert,  ///< bids are not warped: the auction may cycle for ever
  discounted_insert_warped,
  minimax_long_first
};

/// Whether those who agreed exchange what they won, and how hard they look for what to exchange;
/// core/trades/exchanges.hpp.
enum class TradesKind : std::uint8_t { off, cheap, full };

/// How an agent orders the arcs it won; core/tour/tour.hpp.
enum class TourSolver : std::uint8_t { crsom, crsom_ls };

/// Their names in configs, logs and on command lines, in the order of the enumerators.
inline constexpr std::array<std::string_view, 5> policy_names{"claims", "claims-keep", "cbba",
                                                              "cbba-rebuild", "acbba"};
inline constexpr std::array<std::string_view, 7> score_names{
    "minimax",           "minisum",           "independent",
    "discounted-append", "discounted-insert", "discounted-insert-warped",
    "minimax-long-first"};
inline constexpr std::array<std::string_view, 3> trades_names{"off", "cheap", "full"};
inline constexpr std::array<std::string_view, 2> tour_solver_names{"crsom", "crsom+ls"};
constexpr std::string_view name_of(PolicyKind policy) {
  return policy_names[static_cast<std::size_t>(policy)];
}
constexpr std::string_view name_of(ScoreKind score) {
  return score_names[static_cast<std::size_t>(score)];
}
constexpr std::string_view name_of(TradesKind trades) {
  return trades_names[static_cast<std::size_t>(trades)];
}
constexpr std::string_view name_of(TourSolver solver) {
  return tour_solver_names[static_cast<std::size_t>(solver)];
}

/// Whether agents state their own claims; else they exchange tables of beliefs.
constexpr bool states_claims(PolicyKind policy) {
  return policy == PolicyKind::claims || policy == PolicyKind::claims_keep;
}

/// What every agent must agree on for the auction to have one outcome.
struct AuctionSettings {
  PolicyKind policy = PolicyKind::claims;
  ScoreKind score = ScoreKind::minimax;
  double discount_per_s = 0.02;         ///< rho of the discounted scores; > 0.
  std::optional<double> split_m;        ///< piece length; none: the shortest arc's length (eq. 4).
  std::uint32_t max_tasks = 1000;       ///< limit on |T|; the piece length is raised to keep it.
  std::uint32_t bundle_limit = 0;       ///< L_t: most tasks an agent takes; 0: no limit.
  TradesKind trades = TradesKind::off;  ///< exchanges after agreement; off: plain SC-CBBA
  bool audit_bids = true;               ///< recompute what others bid, and refuse what is false.
  TimeNs tick_ns = 20'000'000;          ///< longest time a round waits for those who are silent.
  TimeNs lease_ns = 2'000'000'000;      ///< silence after which an agent counts as dead.
  TimeNs barrier_ns = 10'000'000'000;   ///< how long the start waits for the whole roster.
};

struct TourSettings {
  TourSolver solver = TourSolver::crsom_ls;
  std::uint64_t seed = 1;
  std::uint32_t epochs = 100;     ///< presentations of the whole arc set to the ring.
  std::uint32_t iterations = 20;  ///< disturbances of the local search, for each arc.
};

/// Everything the coordinator publishes, and all an agent needs besides its own id.
struct Mission {
  std::uint64_t id = 0;  ///< distinct for every mission of a domain.
  std::string name;
  std::vector<Arc> arcs;   ///< arcs[i].id.value == i.
  std::vector<Uav> fleet;  ///< the roster, ascending ids.
  Airspace airspace;       ///< empty: legs are straight.
  AuctionSettings auction;
  TourSettings tour;
};

/// Digest over all of it, bit for bit.
std::uint64_t digest(const Mission& mission);

}  // namespace arcbid
