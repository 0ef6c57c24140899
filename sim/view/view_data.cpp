// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/view_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <fstream>

#include "core/base/error.hpp"
#include "core/io/build/build.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/structure_reader.hpp"
#include "sim/replay/explain.hpp"
#include "sim/view/base64.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

template <class T>
std::string little_endian(const std::vector<T>& values) {
  static_assert(std::endian::native == std::endian::little);
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

json line(const std::vector<Waypoint>& waypoints) {
  json out = json::array();
  for (const Waypoint& w : waypoints)
    for (int axis = 0; axis < 3; ++axis) out.push_back(w.position_m[axis]);
  return out;
}

/// As the coordinator left it for whoever looks; a run may have none.
json structure_of(const RunArchive& run) {
  const auto file = run.directory / "structure.ply";
  if (!std::filesystem::exists(file)) return nullptr;
  const Structure structure = read_structure(file, {}).structure;
  std::vector<float> points;
  for (const Vec3& p : structure.points)
    for (int axis = 0; axis < 3; ++axis) points.push_back(static_cast<float>(p[axis]));
  json out{{"points", little_endian(points)}};
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : structure.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  if (!corners.empty()) out["triangles"] = little_endian(corners);
  return out;
}

json arcs_of(const Mission& mission) {
  json out = json::array();
  for (const Arc& arc : mission.arcs)
    out.push_back({{"arc", arc.id.value}, {"kind", name(arc.kind)}, {"line", line(arc.waypoints)}});
  return out;
}

json tasks_of(const RunArchive& run) {
  json out = json::array();
  for (const Task& task : run.tasks.tasks)
    out.push_back({{"task", task.id.value},
                   {"arc", task.arc.value},
                   {"from_m", task.from_m},
                   {"to_m", task.to_m},
                   {"line", line(part(run.mission->arcs[task.arc.value].waypoints, task.from_m,
                                      task.to_m))}});
  return out;
}

json agents_of(const Mission& mission) {
  json out = json::array();
  for (const Uav& uav : mission.fleet)
    out.push_back({{"agent", uav.id.value},
                   {"home", {uav.home_m.x(), uav.home_m.y(), uav.home_m.z()}},
                   {"speed_mps", uav.speed_mps}});
  return out;
}

/// The newest route: vertices with the times at which they are reached; neighbouring legs share
/// theirs.
json route_of(const LifeLog& life, const Uav& uav) {
  const auto routes = life.routes();
  if (routes.empty()) return nullptr;
  const Route& route = routes.back().route;
  json vertices = json::array(), at_s = json::array(), arc = json::array();
  double metres = 0;
  std::optional<Vec3> last;
  for (const RouteLeg& leg : route.legs)
    for (const Waypoint& w : leg.waypoints) {
      if (last && *last == w.position_m) continue;
      if (last) {
        metres += (w.position_m - *last).norm();
        arc.push_back(leg.arc ? json(leg.arc->value) : json(-1));
      }
      for (int axis = 0; axis < 3; ++axis) vertices.push_back(w.position_m[axis]);
      at_s.push_back(metres / uav.speed_mps);
      last = w.position_m;
    }
  return {{"agent", uav.id.value},  {"length_m", route.length_m},
          {"time_s", route.time_s}, {"line", vertices},
          {"at_s", at_s},           {"arc", arc}};
}

json routes_of(const RunArchive& run) {
  json out = json::array();
  for (const Uav& uav : run.mission->fleet) {
    json newest;
    for (const LifeLog& life : run.lives)  // a later life comes later
      if (life.agent() == uav.id && life.ended_by() != "signal")
        if (json route = route_of(life, uav); !route.is_null()) newest = std::move(route);
    if (!newest.is_null()) out.push_back(std::move(newest));
  }
  return out;
}

json summary_of(const RunArchive& run) {
  const AuctionSettings& a = run.mission->auction;
  json out = json::array();
  const auto row = [&out](const char* label, const std::string& text) {
    out.push_back({label, text});
  };
  row("policy", std::string(name_of(a.policy)));
  row("score", std::string(name_of(a.score)));
  row("fleet", fmt::format("{} agents, {} arcs, {} tasks", run.mission->fleet.size(),
                           run.mission->arcs.size(), run.tasks.tasks.size()));
  const json& r = run.result;
  if (!r.is_object()) {
    row("result", run.is_live ? "none on record yet" : "none: it broke off");
    return out;
  }
  if (const json agreement = r.value("agreement", json::object());
      agreement.value("reached", false))
    row("agreement", fmt::format("proven {:.2f} s after launch, {} rounds",
                                 agreement.value("time_s", 0.0), agreement.value("rounds", 0)));
  else
    row("agreement", "none");
  if (r.contains("makespan_s"))
    row("makespan", fmt::format("{:.1f} s", r.value("makespan_s", 0.0)));
  if (r.contains("total_length_m"))
    row("total length", fmt::format("{:.1f} m", r.value("total_length_m", 0.0)));
  const json checks = r.value("checks", json::object());
  for (const auto& [check, holds] : checks.items())
    row(check.c_str(), holds == true ? "yes" : "no");
  return out;
}

/// Why who has what: by task.
json explanations_of(const RunArchive& run, const Playback& playback) {
  const Explainer explainer(run, playback);
  json out = json::object();
  for (const Task& task : run.tasks.tasks) {
    json reasons = json::array();
    for (const Explanation& e : explainer.explain(task.id))
      reasons.push_back({{"t_s", seconds(e.t_ns)}, {"agent", e.agent.value}, {"text", e.text}});
    if (!reasons.empty()) out[std::to_string(task.id.value)] = std::move(reasons);
  }
  return out;
}

/// Splits and healings that were asked for, as marks to jump to.
void add_partitions(const RunArchive& run, json& events) {
  const auto file = run.directory / "faults.yaml";
  std::ifstream in(file);
  if (!in) return;
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const auto mark = [&](TimeNs t_ns, const char* kind, const char* what) {
    events.push_back({{"t_s", seconds(t_ns)}, {"kind", kind}, {"agent", nullptr}, {"text", what}});
  };
  for (const Partition& split : parse_faults(text, file).partitions) {
    mark(split.when.start_ns, "partition", "the fleet is split");
    if (split.when.end_ns < run.lives.front().last_ns() + 3600'000'000'000)
      mark(split.when.end_ns, "heal", "the split heals");
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const json& a, const json& b) { return a["t_s"] < b["t_s"]; });
}

}  // namespace

json view_data(const RunArchive& run) {
  const Playback playback(run);
  json out{{"schema", 1},
           {"name", run.mission->name},
           {"run", run.directory.filename().string()},
           {"live", run.is_live},
           {"build", {{"version", build_version()}, {"commit", build_commit()}}},
           {"summary", summary_of(run)},
           {"arcs", arcs_of(*run.mission)},
           {"tasks", tasks_of(run)},
           {"agents", agents_of(*run.mission)},
           {"auction", auction_data(run, playback)},
           {"mission", {{"routes", routes_of(run)}}},
           {"explanations", explanations_of(run, playback)}};
  add_partitions(run, out["auction"]["events"]);
  if (json structure = structure_of(run); !structure.is_null()) out["structure"] = structure;
  if (json coverage = coverage_data(run.directory); !coverage.is_null())
    out["coverage"] = std::move(coverage);
  return out;
}

}  // namespace arcbid
