// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/mission_misfit.hpp"

#include <fmt/format.h>

#include <cmath>

namespace arcbid {
namespace {

bool is_place(const Vec3& at) {
  constexpr double farthest_m = 1e6;  // structures are read into a local frame
  return at.array().isFinite().all() && at.cwiseAbs().maxCoeff() <= farthest_m;
}

bool is_positive(double value) {
  return std::isfinite(value) && value > 0;
}

bool is_arc(const Arc& arc, std::size_t position) {
  if (arc.id.value != position || arc.waypoints.size() < 2) return false;
  const auto& at = arc.waypoints;
  for (std::size_t w = 0; w < at.size(); ++w)
    if (!is_place(at[w].position_m) || !at[w].look.array().isFinite().all() ||
        (w > 0 && at[w].position_m == at[w - 1].position_m))
      return false;
  return true;
}

/// Whether an access begins on an arc of the mission; the rest of an airspace is unsound()'s.
bool is_access(const Access& access, const std::vector<Arc>& arcs) {
  return access.arc.value < arcs.size() &&
         access.waypoint < arcs[access.arc.value].waypoints.size() && access.points.size() >= 2;
}

std::optional<std::string> misfit(const AuctionSettings& auction) {
  constexpr std::uint32_t most_tasks = 100'000;
  if (auction.max_tasks == 0 || auction.max_tasks > most_tasks)
    return fmt::format("max_tasks is {}", auction.max_tasks);
  if (auction.split_m && !is_positive(*auction.split_m))
    return fmt::format("split_m is {}", *auction.split_m);
  if (!is_positive(auction.discount_per_s))
    return fmt::format("discount_per_s is {}", auction.discount_per_s);
  if (auction.tick_ns <= 0) return fmt::format("tick_ns is {}", auction.tick_ns);
  if (auction.lease_ns <= 0) return fmt::format("lease_ns is {}", auction.lease_ns);
  if (auction.barrier_ns < 0) return fmt::format("barrier_ns is {}", auction.barrier_ns);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> misfit(const Mission& mission) {
  for (std::size_t m = 0; m < mission.arcs.size(); ++m)
    if (!is_arc(mission.arcs[m], m)) return fmt::format("arc {} is no line of waypoints", m);
  for (const Access& access : mission.airspace.accesses)
    if (!is_access(access, mission.arcs))
      return fmt::format("an access of its airspace leads to no waypoint of arc {}",
                         access.arc.value);
  const auto& fleet = mission.fleet;
  for (std::size_t k = 0; k < fleet.size(); ++k) {
    const bool ascends = fleet[k].id > (k > 0 ? fleet[k - 1].id : AgentId{0});
    if (!ascends || !is_place(fleet[k].home_m) || !is_positive(fleet[k].speed_mps) ||
        !is_positive(fleet[k].endurance_s.value_or(1)))
      return fmt::format("agent {} of its fleet is none", k + 1);
  }
  if (mission.arcs.empty() || fleet.empty()) return "it has no arcs or no fleet";
  return misfit(mission.auction);
}

}  // namespace arcbid
