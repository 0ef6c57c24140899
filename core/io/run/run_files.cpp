// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_files.hpp"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "core/io/run/arcs_json.hpp"

namespace arcbid {

using nlohmann::json;

void write_whole(const std::filesystem::path& file, const std::string& text) {
  std::error_code failed;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failed);
  std::filesystem::path beside = file;
  beside += ".part";
  {
    std::ofstream out(beside, std::ios::binary);
    if (!out) throw InputError(fmt::format("{}: no file can be written there", file.string()));
    out << text;
    if (!out.flush())
      throw RunError(fmt::format("{}: cannot be written; is the disk full?", file.string()));
  }
  std::filesystem::rename(beside, file, failed);
  if (failed)
    throw RunError(fmt::format("{}: cannot be written: {}", file.string(), failed.message()));
}

std::filesystem::path route_file(const std::filesystem::path& run, AgentId agent) {
  return run / "routes" / fmt::format("agent_{}.json", agent.value);
}

void write_arcs_file(const std::filesystem::path& run, const Mission& mission) {
  const json out{{"schema", 1},
                 {"mission", {{"id", hex(mission.id)}, {"name", mission.name}}},
                 {"frame", "local East-North-Up, metres"},
                 {"transits", mission.airspace.empty() ? "straight" : "around obstacles"},
                 {"fleet", fleet_json(mission)},
                 {"arcs", arcs_json(mission)}};
  write_whole(run / "arcs.json", out.dump());
}

namespace {

template <class T>
void append_bytes(std::string& out, T value) {
  static_assert(std::endian::native == std::endian::little);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void write_structure_file(const std::filesystem::path& run, const Structure& structure) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
      "y\n"
      "property float z\n",
      structure.points.size());
  if (structure.is_mesh())
    out += fmt::format("element face {}\nproperty list uchar int vertex_indices\n",
                       structure.triangles.size());
  out += "end_header\n";
  for (const Vec3& point : structure.points)
    for (int axis = 0; axis < 3; ++axis) append_bytes(out, static_cast<float>(point[axis]));
  for (const auto& triangle : structure.triangles) {
    out += '\x03';
    for (const std::uint32_t corner : triangle) append_bytes(out, corner);
  }
  write_whole(run / "structure.ply", out);
}

namespace {

json number_of(const std::optional<AgentId>& agent) {
  return agent ? json(agent->value) : json(nullptr);
}

json agreement_of(const TaskSet& tasks, const Agreement& agreement,
                  const std::vector<std::optional<AgentId>>& owners, double time_s) {
  json members = json::array();
  for (const AgentId member : agreement.members) members.push_back(member.value);
  json list = json::array();
  for (const Task& task : tasks.tasks) {
    const Belief& belief = agreement.winners[task.id.value];
    list.push_back({{"task", task.id.value},
                    {"arc", task.arc.value},
                    {"from_m", task.from_m},
                    {"to_m", task.to_m},
                    {"owner", number_of(owners[task.id.value])},
                    {"won_by", number_of(belief.winner)},
                    {"bid", belief.bid}});
  }
  return {{"view_hash", hex(agreement.view_hash)},
          {"round", agreement.round},
          {"time_s", time_s},
          {"members", members},
          {"tasks", list},
          {"no_bidders", no_bidders_json(agreement.left)}};
}

json route_of(const Route& route) {
  json legs = json::array();
  for (const RouteLeg& leg : route.legs) {
    json out;
    out["kind"] = leg.arc ? "arc" : "transit";
    if (leg.arc) {
      out["arc"] = leg.arc->value;
      out["from_m"] = leg.from_m;
      out["to_m"] = leg.to_m;
    }
    out["waypoints"] = json::array();
    for (const Waypoint& waypoint : leg.waypoints)
      out["waypoints"].push_back(waypoint_json(waypoint));
    legs.push_back(std::move(out));
  }
  return {{"length_m", route.length_m},
          {"time_s", route.time_s},
          {"stages", {{"auction_order_m", route.auction_order_m}, {"crsom_m", route.crsom_m}}},
          {"legs", legs}};
}

}  // namespace

void write_route_file(const std::filesystem::path& run, AgentId agent, const Mission& mission,
                      const TaskSet& tasks, const Agreement& agreement,
                      const std::vector<std::optional<AgentId>>& owners, const Route& route,
                      double time_s) {
  const json out{{"schema", 1},
                 {"agent", agent.value},
                 {"mission", hex(mission.id)},
                 {"agreement", agreement_of(tasks, agreement, owners, time_s)},
                 {"route", route_of(route)}};
  write_whole(route_file(run, agent), out.dump());
}

}  // namespace arcbid
