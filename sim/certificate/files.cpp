// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/error.hpp"
#include "sim/checker/json_field.hpp"
#include "sim/checker/run_files.hpp"

namespace arcbid::certificate {
namespace {

using nlohmann::json;

/// JSON has no infinity: null says that there was nothing to measure.
json finite(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json to_json(const Nearest& nearest) {
  if (!std::isfinite(nearest.distance_m)) return nullptr;
  return {{"distance_m", nearest.distance_m},
          {"leg", nearest.leg},
          {"at_m", {nearest.at_m.x(), nearest.at_m.y(), nearest.at_m.z()}}};
}

json to_json(const Sensor& sensor) {
  return {{"kind", sensor.kind == SensorKind::camera ? "camera" : "lidar"},
          {"range_m", sensor.range_m},
          {"least_range_m", sensor.least_range_m},
          {"max_incidence_deg", sensor.max_incidence_deg},
          {"horizontal_fov_deg", sensor.horizontal_fov_deg},
          {"vertical_fov_deg", sensor.vertical_fov_deg},
          {"lowest_look_deg", sensor.lowest_look_deg},
          {"highest_look_deg", sensor.highest_look_deg}};
}

json uncovered(const Certificate& certificate) {
  json list = json::array();
  for (std::size_t f = 1; f < fate_names.size(); ++f)
    if (certificate.fates[f] > 0)
      list.push_back({{"reason", fate_names[f]}, {"count", certificate.fates[f]}});
  return list;
}

json clearance(const Certificate& certificate) {
  json list = json::array();
  for (const AgentClearance& agent : certificate.clearance)
    list.push_back({{"agent", agent.agent},
                    {"nearest", to_json(agent.flight)},
                    {"home", to_json(agent.home)},
                    {"below_floor_m", agent.below_floor_m}});
  return list;
}

json redundancy(const Redundancy& redundancy) {
  json histogram = json::array();
  for (std::size_t bin = 0; bin < redundancy.histogram.size(); ++bin) {
    const std::uint64_t from = bin == 0 ? 1 : (1u << (bin - 1)) + 1, to = 1u << bin;
    const bool is_last = bin + 1 == redundancy.histogram.size();
    histogram.push_back({{"from", from},
                         {"to", is_last ? json(nullptr) : json(to)},
                         {"count", redundancy.histogram[bin]}});
  }
  return {{"mean", redundancy.mean}, {"min", redundancy.least}, {"histogram", histogram}};
}

template <class T>
void append_bytes(std::string& out, T value) {
  static_assert(std::endian::native == std::endian::little);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

Vec3 vec(const checker::Point& p) {
  return {p.x, p.y, p.z};
}

Path path_of(const checker::Path& path) {
  Path out;
  for (const checker::PathPoint& p : path) out.push_back({vec(p.position_m), vec(p.look)});
  return out;
}

}  // namespace

json to_json(const Certificate& c) {
  return {{"schema", 1},
          {"surface_samples", c.surface_samples},
          {"visible_samples", c.visible_samples},
          {"covered_samples", c.covered_samples},
          {"covered_visible_samples", c.covered_visible_samples},
          {"ground_samples", c.ground_samples},
          {"coverage_of_visible", c.coverage_of_visible()},
          {"coverage_of_total", c.coverage_of_total()},
          {"uncovered", uncovered(c)},
          {"surface_m2", c.surface_m2},
          {"covered_m2", c.covered_m2},
          {"flown_m", c.flown_m},
          {"metres_per_m2", c.metres_per_m2()},
          {"safety_m", c.settings.safety_m},
          {"min_clearance_m", finite(c.min_clearance_m())},
          {"keeps_clear", c.keeps_clear()},
          {"home_clearance_m", finite(c.home_clearance_m())},
          {"below_floor_m", c.below_floor_m()},
          {"clearance", clearance(c)},
          {"redundancy", redundancy(c.redundancy)},
          {"spacing_m", c.spacing_m},
          {"seed", fmt::format("{:016x}", c.seed)},
          {"directions", c.directions},
          {"grid_m", c.grid_m},
          {"step_m", c.settings.step_m},
          {"floor_m", c.floor_m},
          {"ray_offset_m", c.ray_offset_m},
          {"tolerance_m", tolerance_m},
          {"sensor", to_json(c.settings.sensor)}};
}

std::string samples_file(const Certificate& certificate) {
  std::string out = "ARCBSMPL";
  append_bytes(out, std::uint32_t{1});
  append_bytes(out, static_cast<std::uint32_t>(certificate.samples.size()));
  for (const SampleResult& sample : certificate.samples) {
    for (int axis = 0; axis < 3; ++axis)
      append_bytes(out, static_cast<float>(sample.position_m[axis]));
    for (int axis = 0; axis < 3; ++axis)
      append_bytes(out, static_cast<std::int8_t>(std::lround(127 * sample.normal[axis])));
    append_bytes(out, static_cast<std::uint8_t>(sample.fate));
    append_bytes(out, static_cast<std::uint16_t>(std::min(sample.times, 65535u)));
    append_bytes(out, static_cast<std::uint8_t>(sample.visible ? 1 : 0));
    append_bytes(out, std::uint8_t{0});
  }
  return out;
}

Flown read_flown(const std::filesystem::path& run) {
  try {
    Flown flown;
    for (const auto& [id, arc] : checker::read_published(run / "arcs.json").arcs)
      flown.arcs.push_back(path_of(arc.waypoints));
    for (const std::filesystem::path& file : checker::route_files(run)) {
      const checker::Delivered delivered = checker::read_delivered(file);
      Flight flight{delivered.agent, {}};
      for (const checker::Leg& leg : delivered.legs)
        flight.legs.push_back({leg.arc, path_of(leg.waypoints)});
      flown.flights.push_back(std::move(flight));
    }
    return flown;
  } catch (const checker::DamagedFile& damaged) {
    throw InputError(damaged.what());
  }
}

}  // namespace arcbid::certificate
