// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// One UAV of the fleet.
struct Uav {
  AgentId id;
  Vec3 home_m = Vec3::Zero();
  double speed_mps = 1.0;
};

enum class PolicyKind : std::uint8_t { claims, cbba };
enum class ScoreKind : std::uint8_t { minimax, minisum, discounted };

/// What every agent must agree on for the auction to have one outcome.
struct AuctionSettings {
  PolicyKind policy = PolicyKind::claims;
  ScoreKind score = ScoreKind::minimax;
  double discount_per_s = 0.02;        ///< rho of the time-discounted score; > 0.
  std::optional<double> split_m;       ///< piece length; none: the shortest arc's length (eq. 4).
  std::uint32_t max_tasks = 1000;      ///< limit on |T|; the piece length is raised to keep it.
  std::uint32_t bundle_limit = 0;      ///< L_t: most tasks an agent takes; 0: no limit.
  TimeNs tick_ns = 20'000'000;         ///< least time between two rounds of one agent.
  TimeNs lease_ns = 2'000'000'000;     ///< silence after which an agent counts as dead.
  TimeNs barrier_ns = 10'000'000'000;  ///< how long the start waits for the whole roster.
};

struct TourSettings {
  std::uint64_t seed = 1;
  std::uint32_t epochs = 100;  ///< presentations of the whole arc set to the ring.
};

/// Everything the coordinator publishes, and all an agent needs besides its own id.
struct Mission {
  std::uint64_t id = 0;  ///< distinct for every mission of a domain.
  std::string name;
  std::vector<Arc> arcs;   ///< arcs[i].id.value == i.
  std::vector<Uav> fleet;  ///< the roster, ascending ids.
  AuctionSettings auction;
  TourSettings tour;
};

/// Digest over all of it, bit for bit.
std::uint64_t digest(const Mission& mission);

}  // namespace arcbid
