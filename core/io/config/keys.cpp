// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/io/config/make_key.hpp"

namespace arcbid::yaml {
namespace {

Keys<ParametricBridge> parametric_keys() {
  using P = ParametricBridge;
  return {
      key("kind", &P::kind,
          choice<BridgeKind>({{"girder", BridgeKind::girder},
                              {"arch", BridgeKind::arch},
                              {"towers", BridgeKind::towers}}),
          "Piers only, an arch, or towers."),
      key("length_m", &P::length_m, number<double>(1, 5000), "Length of the deck, along x."),
      key("width_m", &P::width_m, number<double>(1, 200), "Width of the deck, along y."),
      key("deck_height_m", &P::deck_height_m, number<double>(1, 1000),
          "Height of the deck's top above the ground."),
      key("deck_thickness_m", &P::deck_thickness_m, number<double>(0.1, 20),
          "Thickness of the deck."),
      key("piers", &P::piers, number<std::uint32_t>(0, 100),
          "Number of piers, or of towers, in equal spans."),
      key("pier_width_m", &P::pier_width_m, number<double>(0.1, 50),
          "Width of a pier or tower leg; thickness of the arch."),
      key("girders", &P::girders, number<std::uint32_t>(0, 50), "Girders under the deck."),
      key("girder_depth_m", &P::girder_depth_m, number<double>(0.1, 20),
          "How far the girders reach below the deck."),
      key("tower_height_m", &P::tower_height_m, number<double>(1, 1000),
          "Height of the towers' tops, or of the arch's crown."),
  };
}

Keys<StructureConfig> structure_keys() {
  using S = StructureConfig;
  Keys<S> keys = {
      key("file", &S::file, file_name(),
          "Point cloud or mesh to inspect, relative to the config's folder. Absent: the built-in "
          "bridge described by `structure.parametric`."),
      key("unit", &S::unit,
          choice<std::string>({{"m", "m"},
                               {"cm", "cm"},
                               {"mm", "mm"},
                               {"ft", "ft"},
                               {"us-ft", "us-ft"},
                               {"in", "in"}}),
          "Unit of the file's coordinates."),
      key("up", &S::up, choice<char>({{"x", 'x'}, {"y", 'y'}, {"z", 'z'}}),
          "Axis of the file that points up."),
  };
  add_section(keys, "parametric", &S::parametric, parametric_keys());
  return keys;
}

Keys<CoverageSettings> coverage_keys() {
  using C = CoverageSettings;
  Keys<C> keys = {
      key("spacing_m", &C::spacing_m, number<double>(0.2, 100),
          "D: greatest distance between neighbouring path lines; what the scanner's width allows."),
      key("standoff_m", &C::standoff_m, number<double>(0.2, 100),
          "Distance at which a UAV flies beside the surface."),
      key("safety_m", &C::safety_m, number<double>(0.1, 100),
          "Least distance of any path point from the surface; some below `coverage.standoff_m`."),
      key("ground_clearance_m", &C::ground_clearance_m, number<double>(0, 100),
          "No path lower than this above the ground."),
      key("ground_m", &C::ground_m, number_or<double>("lowest_point", -100000, 100000),
          "Height (z) of the ground; `lowest_point`: that of the structure."),
      key("rows", &C::rows,
          choice<RowSide>({{"short_side", RowSide::short_side}, {"long_side", RowSide::long_side}}),
          "Which side of a horizontal surface its rows run along; the short one gives even arcs."),
      key("seed", &C::seed, number<std::uint64_t>(0, 4294967295),
          "Seed of the surface samples that the paths are planned and checked with."),
      key("fill", &C::fill, boolean(),
          "Also plan paths for what slices and rows leave unseen (COVERAGE.md)."),
      key("trim", &C::trim, boolean(),
          "Leave out stretches of paths that no surface sample needs, and join what is left."),
      key("ground_points", &C::ground_points,
          choice<GroundPoints>({{"auto", GroundPoints::automatic}, {"keep", GroundPoints::keep}}),
          "Points of a cloud on the ground: `auto` tells them from the structure, and does not "
          "inspect them; `keep` does."),
  };
  add_section(keys, "sensor", &C::sensor, sensor_keys());
  return keys;
}

Keys<AuctionSettings> auction_keys() {
  using A = AuctionSettings;
  return {
      key("policy", &A::policy, choice(enumerators<PolicyKind>(policy_names)),
          "How conflicts are resolved: each agent states its own claims and rebuilds its bundle "
          "(or keeps what it was not outbid on), or tables as in CBBA (Choi, Brunet, How 2009), "
          "CBBA with rebuild, or ACBBA. Only claims survive every fault; see THEORY.md."),
      key("score", &A::score, choice(enumerators<ScoreKind>(score_names)),
          "What a bid rewards: an early end of the agent's whole tour, a short detour, nearness to "
          "home, or an early visit: at the end of the path or where it fits best. "
          "`minimax-long-first` is minimax that takes long arcs while there is room for them. "
          "`discounted-insert` bids without warping and may cycle for ever."),
      key("discount_per_s", &A::discount_per_s, number<double>(1e-6, 10),
          "Rate at which the discounted scores fall with time."),
      key("split_m", &A::split_m, number_or<double>("shortest_arc", 0.1, 10000),
          "Arcs are cut into pieces of this length before the auction; `shortest_arc`: the "
          "shortest arc's length (eq. 4)."),
      key("max_tasks", &A::max_tasks, number<std::uint32_t>(1, 100000),
          "Most pieces; the piece length is raised, with a warning, to keep it."),
      key("bundle_limit", &A::bundle_limit, number<std::uint32_t>(0, 100000),
          "L_t: most pieces an agent takes; 0: no limit."),
      key("trades", &A::trades, choice(enumerators<TradesKind>(trades_names)),
          "Exchanges between two UAVs at a time after the auction, and how hard they are looked "
          "for; "
          "`off`: the paper's plain SC-CBBA. See TRADES.md."),
      key("audit_bids", &A::audit_bids, boolean(),
          "Recompute what others bid, and refuse bids that are false; see FAULTS.md."),
      key("tick_ms", &A::tick_ns, milliseconds(1, 10000),
          "Longest time that a round waits for those who do not speak, and least between two tries "
          "to "
          "say something again."),
      key("lease_ms", &A::lease_ns, milliseconds(250, 600000),
          "An agent that was not heard of for this long counts as dead; at least 3 ticks."),
      key("barrier_ms", &A::barrier_ns, milliseconds(0, 600000),
          "How long the start waits for all agents."),
  };
}

Keys<TourSettings> tour_keys() {
  using T = TourSettings;
  return {
      key("solver", &T::solver, choice(enumerators<TourSolver>(tour_solver_names)),
          "How an agent orders the arcs it won: along the ring alone, as the paper does, or "
          "improved "
          "by local search."),
      key("seed", &T::seed, number<std::uint64_t>(0, 4294967295),
          "Seed of the order in which arcs are shown to the ring (CRSOM), and of the local "
          "search."),
      key("epochs", &T::epochs, number<std::uint32_t>(1, 100000),
          "How often the whole arc set is shown to the ring."),
      key("iterations", &T::iterations, number<std::uint32_t>(0, 1000000),
          "How often the local search disturbs and repairs the tour, for each arc; about 100,000 "
          "in "
          "all a second."),
  };
}

Keys<NetworkConfig> network_keys() {
  using N = NetworkConfig;
  return {
      key("transport", &N::transport,
          choice<TransportKind>({{"loopback", TransportKind::loopback},
                                 {"discovery_server", TransportKind::discovery_server}}),
          "How processes find each other: all on this host, or through a discovery server."),
      key("domain", &N::domain, number_or<std::uint32_t>("auto", 0, 232),
          "DDS domain; `auto`: one that keeps two runs on one host apart."),
      key("server_address", &N::server_address, ipv4_address(), "Where the discovery server is."),
      key("server_port", &N::server_port, number<std::uint16_t>(1, 65535),
          "The discovery server's port."),
      key("interface_address", &N::interface_address, ipv4_address(),
          "This host's address on the network that the fleet shares."),
      key("reliable_bids", &N::reliable_bids, boolean(),
          "Let DDS repeat lost bids. The auction does not need it."),
  };
}

Keys<Config> all_keys() {
  Keys<Config> keys = {key("name", &Config::name, title(), "Names the run in logs and folders.")};
  add_section(keys, "structure", &Config::structure, structure_keys());
  add_section(keys, "coverage", &Config::coverage, coverage_keys());
  add_section(keys, "fleet", &Config::fleet, fleet_keys());
  add_section(keys, "auction", &Config::auction, auction_keys());
  add_section(keys, "tour", &Config::tour, tour_keys());
  add_section(keys, "network", &Config::network, network_keys());
  keys.push_back(key("timeout_s", &Config::timeout_s, number<double>(1, 86400),
                     "The launcher gives up so long after the mission is published."));
  return keys;
}

}  // namespace

const Keys<Config>& config_keys() {
  static const Keys<Config> keys = all_keys();
  return keys;
}

}  // namespace arcbid::yaml
