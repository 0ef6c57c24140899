// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>

#include "core/base/error.hpp"
#include "core/io/config.hpp"
#include "core/io/config/keys.hpp"
#include "core/io/config/together.hpp"

namespace arcbid {
namespace yaml {
namespace {

/// The built-in bridge must stand: `generate` refuses the same ones, but knows no file and line.
void check_bridge(const ParametricBridge& bridge, Report& report) {
  const auto conflict = [&](const std::vector<std::string>& words, const std::string& text) {
    std::vector<std::string> paths;
    for (const std::string& word : words) paths.push_back("structure.parametric." + word);
    report.conflict(paths, text);
  };
  const double girders_m = bridge.girders > 0 ? bridge.girder_depth_m : 0;
  if (bridge.deck_thickness_m + girders_m >= bridge.deck_height_m)
    conflict({"deck_height_m", "deck_thickness_m", "girder_depth_m", "girders"},
             fmt::format("{} is not more than the deck ({}) and its girders ({}) need",
                         bridge.deck_height_m, bridge.deck_thickness_m, girders_m));
  const bool is_arch = bridge.kind == BridgeKind::arch,
             is_towers = bridge.kind == BridgeKind::towers;
  const double span_m = bridge.length_m / (bridge.piers + 1);
  if ((bridge.piers > 0 || is_arch) && bridge.pier_width_m > span_m)
    conflict(
        {"pier_width_m", "piers", "length_m", "kind"},
        fmt::format("{} is more than the {:.4g} m from pier to pier", bridge.pier_width_m, span_m));
  if (is_towers && bridge.piers == 0)
    conflict({"piers", "kind"}, "0 is outside [1, 100] for a bridge with towers");
  if (is_towers && bridge.tower_height_m < bridge.deck_height_m)
    conflict(
        {"tower_height_m", "deck_height_m", "kind"},
        fmt::format("{} is below deck_height_m, {}", bridge.tower_height_m, bridge.deck_height_m));
  if (is_arch && bridge.tower_height_m < bridge.pier_width_m)
    conflict({"tower_height_m", "pier_width_m", "kind"},
             fmt::format("{} is less than the arch is thick (pier_width_m, {})",
                         bridge.tower_height_m, bridge.pier_width_m));
}

void check_file(const std::filesystem::path& file, Report& report) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    report.conflict({"structure.file"}, "no such file: " + shown(file.string()));
  else if (std::filesystem::is_directory(file, ignored))
    report.conflict({"structure.file"}, "a folder: " + shown(file.string()));
}

/// The arcs need some room between the two distances, for the corners of the offset outlines.
void check_coverage(const CoverageSettings& coverage, Report& report) {
  constexpr double room = 1.1;
  if (coverage.safety_m * room > coverage.standoff_m)
    report.conflict(
        {"coverage.safety_m", "coverage.standoff_m"},
        fmt::format("{} is too near coverage.standoff_m, {}; at most {:.4g} is legal",
                    coverage.safety_m, coverage.standoff_m, coverage.standoff_m / room));
}

/// A sensor that sees nothing at the stand-off would cover nothing.
void check_sensor(const CoverageSettings& coverage, Report& report) {
  const Sensor& sensor = coverage.sensor;
  const std::string prefix = "coverage.sensor.";
  if (sensor.range_m <= coverage.standoff_m)
    report.conflict({prefix + "range_m", "coverage.standoff_m"},
                    fmt::format("{} does not exceed coverage.standoff_m, {}: it would see nothing",
                                sensor.range_m, coverage.standoff_m));
  if (sensor.least_range_m >= coverage.standoff_m)
    report.conflict({prefix + "least_range_m", "coverage.standoff_m"},
                    fmt::format("{} is not below coverage.standoff_m, {}: it would see nothing",
                                sensor.least_range_m, coverage.standoff_m));
  if (sensor.lowest_look_deg > sensor.highest_look_deg)
    report.conflict({prefix + "lowest_look_deg", prefix + "highest_look_deg"},
                    fmt::format("{} is above highest_look_deg, {}", sensor.lowest_look_deg,
                                sensor.highest_look_deg));
  const bool is_flat = sensor.kind == SensorKind::camera;
  if (is_flat && std::max(sensor.horizontal_fov_deg, sensor.vertical_fov_deg) >= 180)
    report.conflict({prefix + "horizontal_fov_deg", prefix + "vertical_fov_deg", prefix + "kind"},
                    fmt::format("{} by {} is no camera's field of view; legal: less than 180",
                                sensor.horizontal_fov_deg, sensor.vertical_fov_deg));
}

void check_fleet(const FleetConfig& fleet, Report& report) {
  if (!fleet.uavs.empty() && fleet.agents != fleet.uavs.size())
    report.conflict({"fleet.agents", "fleet.uavs"},
                    fmt::format("{}, but fleet.uavs lists {}; leave one of the two out",
                                fleet.agents, fleet.uavs.size()));
  std::map<AgentId, std::size_t> first;
  for (std::size_t i = 0; i < fleet.uavs.size(); ++i) {
    const std::string path = fmt::format("fleet.uavs[{}].id", i);
    const auto [earlier, is_new] = first.emplace(fleet.uavs[i].id, i);
    if (!is_new && fleet.uavs[i].id.value > 0)  // 0: not given, which is reported already
      report.conflict({path}, fmt::format("{} is the id of fleet.uavs[{}] already",
                                          fleet.uavs[i].id.value, earlier->second));
  }
}

void check_network(const NetworkConfig& network, Report& report) {
  const auto is_this_host = [](const std::string& ip) { return ip.starts_with("127."); };
  if (network.transport != TransportKind::discovery_server || is_this_host(network.server_address))
    return;
  if (is_this_host(network.interface_address))
    report.conflict({"network.interface_address", "network.server_address"},
                    fmt::format("{} cannot reach the server at {}; legal: this host's address on "
                                "that network",
                                network.interface_address, network.server_address));
  if (!network.domain)
    report.conflict({"network.domain", "network.server_address"},
                    "auto differs from host to host; legal with a remote server: an integer in "
                    "[0, 232]");
}

}  // namespace

void check_together(const Config& config, Report& report) {
  if (config.structure.file)
    check_file(*config.structure.file, report);
  else
    check_bridge(config.structure.parametric, report);
  check_coverage(config.coverage, report);
  check_sensor(config.coverage, report);
  check_fleet(config.fleet, report);
  if (config.auction.lease_ns / 3 < config.auction.tick_ns)
    report.conflict({"auction.lease_ms", "auction.tick_ms"},
                    fmt::format("{} is less than 3 ticks of {} ms: the living would count as dead",
                                static_cast<double>(config.auction.lease_ns) / 1e6,
                                static_cast<double>(config.auction.tick_ns) / 1e6));
  check_network(config.network, report);
}

}  // namespace yaml

void validate(const Config& config) {
  yaml::Report report("");
  Config copy;
  for (const yaml::Key<Config>& key : yaml::config_keys())
    if (const std::string text = key.print(config); !text.empty())
      key.read({YAML::Load(text), YAML::Mark::null_mark(), key.name}, copy, report);
  yaml::check_together(config, report);
  report.throw_if_any();
}

std::uint32_t domain_of(std::optional<std::uint32_t> asked, const Config& config) {
  if (asked) return *asked;
  if (config.network.domain) return *config.network.domain;
  throw InputError(
      "network.domain: auto is chosen by 'arcbid run' for all its processes; started by hand, each "
      "needs the same "
      "--domain, 0 to 232");
}

}  // namespace arcbid
