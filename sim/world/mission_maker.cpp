// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/mission_maker.hpp"

#include <algorithm>
#include <cmath>

namespace arcbid {
namespace {

constexpr double box_m = 100, height_m = 30, grid_m = 20;

template <class T>
const T& any_of_these(const std::vector<T>& choices, Dice& dice) {
  return choices[dice.between(0, static_cast<std::uint32_t>(choices.size() - 1))];
}

Vec3 scattered(Dice& dice) {
  const double x = dice.within(0, box_m), y = dice.within(0, box_m);
  return {x, y, dice.within(0, height_m)};
}

Vec3 on_grid(Vec3 point) {
  for (int axis = 0; axis < 3; ++axis) point[axis] = grid_m * std::round(point[axis] / grid_m);
  return point;
}

/// Where things are: around a few centres when clustered, on the nodes of a grid, or anywhere.
class Places {
 public:
  Places(Layout layout, Dice& dice) : layout_(layout), dice_(dice) {
    for (std::uint32_t n = dice.between(1, 3); n > 0; --n) centres_.push_back(scattered(dice));
  }

  Vec3 point() {
    const Vec3 anywhere = scattered(dice_);
    if (layout_ == Layout::grid) return on_grid(anywhere);
    if (layout_ == Layout::scattered) return anywhere;
    return any_of_these(centres_, dice_) + 0.1 * (anywhere - Vec3(50, 50, 15));
  }

  Vec3 direction() {
    const double angle = dice_.within(0, 6.28);
    if (layout_ == Layout::grid) return angle < 3.14 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    return Vec3(std::cos(angle), std::sin(angle), dice_.within(-0.3, 0.3)).normalized();
  }

 private:
  Layout layout_;
  Dice& dice_;
  std::vector<Vec3> centres_;
};

/// Arcs that the piece length cuts into exactly `tasks` pieces. The last piece of an arc is a part
/// of it, on a grid a whole one.
std::vector<Arc> make_arcs(std::uint32_t tasks, double piece_m, Layout layout, Places& places,
                           Dice& dice) {
  std::vector<Arc> arcs;
  for (std::uint32_t left = tasks; left > 0;) {
    const std::uint32_t pieces = std::min(left, dice.between(1, 6));
    const double part = layout == Layout::grid ? 1 : dice.within(0.1, 0.9);
    const Vec3 first = places.point();
    const Vec3 last = first + (pieces - 1 + part) * piece_m * places.direction();
    const auto id = static_cast<std::uint32_t>(arcs.size());
    arcs.push_back({{id}, ArcKind::outline, {{first, Vec3::UnitX()}, {last, Vec3::UnitX()}}});
    left -= pieces;
  }
  return arcs;
}

Payload any_payload(Dice& dice) {
  return static_cast<Payload>(dice.between(0, payload_names.size() - 1));
}

/// With dice of its own, so that what else a seed stands for does not change. On a grid tours often
/// take just as long as a UAV lasts.
void limit_fleet(const WorldSettings& settings, std::uint64_t seed, Layout layout,
                 Mission& mission) {
  constexpr std::uint64_t other_dice = 0x11d175;
  Dice dice(seed ^ other_dice);
  if (dice.chance(settings.endurance))
    for (Uav& uav : mission.fleet) {
      if (dice.chance(0.2)) continue;
      const double range_m = dice.within(60, 600);
      const double even_m = layout == Layout::grid ? grid_m * std::ceil(range_m / grid_m) : range_m;
      uav.endurance_s = even_m / uav.speed_mps;
    }
  if (!dice.chance(settings.payloads)) return;
  for (Uav& uav : mission.fleet) uav.payload = any_payload(dice);
  for (Arc& arc : mission.arcs) arc.payload = any_payload(dice);
}

}  // namespace

Mission make_mission(const WorldSettings& settings, std::uint64_t seed, Dice& dice) {
  const Layout layout = any_of_these(settings.layouts, dice);
  Places places(layout, dice);
  Mission mission{.id = seed,
                  .name = settings.name,
                  .arcs = {},
                  .fleet = {},
                  .airspace = {},
                  .auction = {},
                  .tour = {}};
  const std::uint32_t tasks = dice.between(settings.tasks.least, settings.tasks.most);
  const double piece_m = layout == Layout::grid ? grid_m : dice.within(4, 20);
  mission.arcs = make_arcs(tasks, piece_m, layout, places, dice);
  const std::uint32_t agents = dice.between(settings.agents.least, settings.agents.most);
  for (std::uint32_t i = 1; i <= agents; ++i) {
    Vec3 home_m = places.point();
    home_m.z() = 0;
    const double speed_mps = layout == Layout::grid ? 2 : dice.within(1, 4);
    mission.fleet.push_back({{i}, home_m, speed_mps});
  }
  AuctionSettings& auction = mission.auction;
  auction.policy = any_of_these(settings.policies, dice);
  auction.score = any_of_these(settings.scores, dice);
  auction.split_m = piece_m;
  auction.tick_ns = settings.tick_ns;
  auction.lease_ns = dice.time_ns(settings.lease_ns.least, settings.lease_ns.most);
  auction.barrier_ns = dice.time_ns(5 * settings.tick_ns, 40 * settings.tick_ns);
  if (dice.chance(settings.bundle_limit))
    auction.bundle_limit = dice.between(1, 2 * ((tasks + agents - 1) / agents));
  // One choice is no chance: worlds of settings that name none stay what they were.
  auction.trades =
      settings.trades.size() == 1 ? settings.trades[0] : any_of_these(settings.trades, dice);
  limit_fleet(settings, seed, layout, mission);
  return mission;
}

}  // namespace arcbid
