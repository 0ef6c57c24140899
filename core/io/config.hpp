// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/structure/bridge_arcs.hpp"
#include "core/structure/parametric.hpp"

namespace arcbid {

enum class TransportKind : std::uint8_t { loopback, discovery_server };

struct NetworkConfig {
  TransportKind transport = TransportKind::loopback;
  std::optional<std::uint32_t> domain;       ///< none: chosen so that two runs at once do not meet
  std::string server_address = "127.0.0.1";  ///< discovery server's IPv4 address
  std::uint16_t server_port = 11811;
  std::string interface_address = "127.0.0.1";  ///< IPv4 of the interface to use
  bool reliable_bids = false;  ///< bids and relays over RELIABLE instead of BEST_EFFORT
};

struct StructureConfig {
  std::optional<std::filesystem::path> file;  ///< none: the parametric bridge
  std::string unit = "m";                     ///< m | cm | mm | ft | us-ft | in
  char up = 'z';                              ///< x | y | z: the file's vertical axis
  ParametricBridge parametric;
};

struct FleetConfig {
  std::uint32_t agents = 4;
  std::uint32_t agents_per_process = 1;  ///< more: fewer, larger processes
  double speed_mps = 1.0;
  std::optional<double> endurance_s;  ///< none: no limit
  Payload payload = Payload::any;
  /// Explicit UAVs; empty: `agents` of them in a row on the ground beside the structure.
  std::vector<Uav> uavs;
};

/// What gives the shortest missions at little cost; the core's own defaults are plain SC-CBBA.
inline AuctionSettings best_auction() {
  AuctionSettings auction;
  auction.score = ScoreKind::minimax_long_first;
  auction.trades = TradesKind::cheap;
  return auction;
}

/// A run, as configs/*.yaml describes it. Every default stands here and in docs/CONFIG.md.
struct Config {
  std::string name = "mission";
  StructureConfig structure;
  CoverageSettings coverage;
  FleetConfig fleet;
  AuctionSettings auction = best_auction();
  TourSettings tour;
  NetworkConfig network;
  double timeout_s = 120.0;  ///< the launcher gives up so long after the mission is published
};

/// The ids of the UAVs that the config asks for: its own, or 1 to `agents`.
inline std::vector<AgentId> fleet_ids(const Config& config) {
  std::vector<AgentId> ids;
  for (const Uav& uav : config.fleet.uavs) ids.push_back(uav.id);
  for (std::uint32_t i = 1; config.fleet.uavs.empty() && i <= config.fleet.agents; ++i)
    ids.push_back({i});
  return ids;
}
inline std::uint32_t fleet_size(const Config& config) {
  return static_cast<std::uint32_t>(fleet_ids(config).size());
}

/// The domain of a process that is started by hand: `asked`, or the config's. Throws InputError
/// when neither says one: only a launcher can choose a free one for all.
std::uint32_t domain_of(std::optional<std::uint32_t> asked, const Config& config);

/// Reads and validates a YAML file. All errors at once, one line each
/// ("demo.yaml:4:20: fleet.uavs[1].speed_mps: -3 is outside [0.1, 30]"), joined by '\n' in one
/// InputError. Relative file names are taken from the config's folder and made absolute; uavs are
/// sorted by id.
Config load_config(const std::filesystem::path& file);

/// The same from text; `file` stands in the messages, and its folder is where relative names start.
Config parse_config(const std::string& text, const std::filesystem::path& file);

/// Checks a config whose fields were set by hand: every range, and what must go together. Throws
/// one InputError, one line a problem ("fleet.agents: 0 is outside [1, 64]").
void validate(const Config& config);

/// The whole config as YAML that load_config reads back to the same value (--print-config).
std::string to_yaml(const Config& config);

/// A table of every key, its type or range, default and meaning, in Markdown (docs/CONFIG.md is
/// this).
std::string config_reference();

}  // namespace arcbid
