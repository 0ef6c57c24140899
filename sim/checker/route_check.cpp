// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/checker/checks.hpp"
#include "sim/checker/coverage.hpp"

namespace arcbid::checker {

namespace {

constexpr double kUnitTolerance = 1e-6;

void check_joins(const FleetAgent& uav, const Delivered& delivered, Problems& problems) {
  Point here = uav.home_m;
  std::string from = "home";
  const auto expect_at = [&](const Point& p, const std::string& to) {
    const double jump_m = distance(here, p);
    if (jump_m > kTolerance_m)
      problems.add(fmt::format("agent {}: a jump of {:.4f} m from {} at {} to {} at {}",
                               delivered.agent, jump_m, from, text(here), to, text(p)));
  };
  for (std::size_t k = 0; k < delivered.legs.size(); ++k) {
    const Path& path = delivered.legs[k].waypoints;
    expect_at(path.front().position_m, fmt::format("the start of leg {}", k));
    here = path.back().position_m;
    from = fmt::format("the end of leg {}", k);
  }
  expect_at(uav.home_m, "home");
}

void check_looks(const Delivered& delivered, std::size_t leg, Problems& problems) {
  const Path& path = delivered.legs[leg].waypoints;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (!(std::abs(norm(path[i].look) - 1) <= kUnitTolerance))
      problems.add(fmt::format("agent {} leg {}: the look {} of waypoint {} is not a unit vector",
                               delivered.agent, leg, text(path[i].look), i));
}

void check_arc_leg(const Published& published, const Delivered& delivered, std::size_t index,
                   Problems& problems) {
  const Leg& leg = delivered.legs[index];
  const auto found = published.arcs.find(*leg.arc);
  std::string reason;
  if (found == published.arcs.end()) {
    reason = "was never published";
  } else {
    const PublishedArc& arc = found->second;
    const auto [low_m, high_m] = std::minmax({leg.from_m, leg.to_m});
    if (low_m < -kTolerance_m || high_m > arc.length_m + kTolerance_m)
      reason = fmt::format("is only {:.4f} m long", arc.length_m);
    else
      reason = why_not_the_stretch(leg.waypoints, arc.waypoints, leg.from_m, leg.to_m);
  }
  if (!reason.empty())
    problems.add(fmt::format("agent {} leg {} (arc {} {} to {} m): {}", delivered.agent, index,
                             *leg.arc, leg.from_m, leg.to_m, reason));
}

/// What it won and what it flies, as stretches of the same arcs.
void check_won_is_flown(const Delivered& delivered, Problems& problems) {
  struct Sides {
    std::vector<Stretch> won, flown;
  };
  std::map<std::uint32_t, Sides> arcs;
  const auto stretch = [](double a_m, double b_m) {
    return Stretch{std::min(a_m, b_m), std::max(a_m, b_m), {}};
  };
  for (const TaskRow& row : delivered.tasks)
    if (row.owner == delivered.agent) arcs[row.arc].won.push_back(stretch(row.from_m, row.to_m));
  for (const Leg& leg : delivered.legs)
    if (leg.arc) arcs[*leg.arc].flown.push_back(stretch(leg.from_m, leg.to_m));
  for (auto& [arc, sides] : arcs) {
    const double by_m = difference_m(std::move(sides.won), std::move(sides.flown));
    if (by_m > kTolerance_m)
      problems.add(
          fmt::format("agent {}: what it won of arc {} and what it flies differ by {:.4f} m",
                      delivered.agent, arc, by_m));
  }
}

void check_sums(const FleetAgent& uav, const Delivered& delivered, Problems& problems) {
  const double sum_m = flown_m(delivered);
  if (!same_length(delivered.length_m, sum_m))
    problems.add(fmt::format("agent {}: length_m is {:.4f}, its waypoints add up to {:.4f}",
                             delivered.agent, delivered.length_m, sum_m));
  if (!same_length(delivered.time_s * uav.speed_mps, sum_m))
    problems.add(fmt::format("agent {}: time_s is {:.4f}, {:.4f} m at {} m/s take {:.4f}",
                             delivered.agent, delivered.time_s, sum_m, uav.speed_mps,
                             sum_m / uav.speed_mps));
}

/// What it carries and how long it lasts: rounding is no reason to call a route too long.
void check_limits(const Published& published, const FleetAgent& uav, const Delivered& delivered,
                  Problems& problems) {
  constexpr double rounding = 1e-6;
  const double time_s = flown_m(delivered) / uav.speed_mps;
  if (uav.endurance_s && time_s > *uav.endurance_s * (1 + rounding))
    problems.add(fmt::format("agent {}: its route takes {:.4f} s, its endurance is {} s",
                             delivered.agent, time_s, *uav.endurance_s));
  for (std::size_t k = 0; k < delivered.legs.size(); ++k) {
    const auto& arc = delivered.legs[k].arc;
    const auto found = arc ? published.arcs.find(*arc) : published.arcs.end();
    if (found != published.arcs.end() && !uav.serves(found->second.payload))
      problems.add(fmt::format("agent {} leg {}: arc {} needs a {}, it carries a {}",
                               delivered.agent, k, *arc, found->second.payload, uav.payload));
  }
}

}  // namespace

void check_route(const Published& published, const Delivered& delivered, Problems& problems) {
  if (delivered.mission != published.mission)
    problems.add(fmt::format("agent {}: its route is for mission {}, this is mission {}",
                             delivered.agent, delivered.mission, published.mission));
  const auto uav = published.fleet.find(delivered.agent);
  if (uav == published.fleet.end()) {
    problems.add(fmt::format("agent {} is not in the fleet", delivered.agent));
    return;
  }
  check_joins(uav->second, delivered, problems);
  for (std::size_t k = 0; k < delivered.legs.size(); ++k) {
    check_looks(delivered, k, problems);
    if (delivered.legs[k].arc) check_arc_leg(published, delivered, k, problems);
  }
  check_won_is_flown(delivered, problems);
  check_sums(uav->second, delivered, problems);
  check_limits(published, uav->second, delivered, problems);
}

double flown_m(const Delivered& delivered) {
  double sum = 0;
  for (const Leg& leg : delivered.legs) sum += length_m(leg.waypoints);
  return sum;
}

}  // namespace arcbid::checker
