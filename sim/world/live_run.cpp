// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/live_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>

#include "core/arcs/mission_misfit.hpp"
#include "core/base/digest.hpp"
#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/run/arcs_json.hpp"
#include "core/io/run/json_place.hpp"
#include "core/io/run/log_files.hpp"
#include "core/io/run/log_schemas.hpp"
#include "core/io/run/run_log_reader.hpp"

namespace arcbid {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

constexpr std::uint64_t most_id = std::numeric_limits<std::uint32_t>::max();

json parsed(const Path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: missing, or not readable", file.string()));
  json out = json::parse(in, nullptr, false);
  if (out.is_discarded()) throw InputError(fmt::format("{}: is not JSON", file.string()));
  return out;
}

/// Names of processes ("agent 2, second") by their PIDs.
std::map<std::uint64_t, std::string> names_of(const JsonPlace& result) {
  std::map<std::uint64_t, std::string> names;
  if (result.has("world")) return names;  // all of it was one process
  for (const JsonPlace& process : result.at("processes").elements())
    names[process.at("pid").whole(most_id)] = process.at("name").text();
  return names;
}

std::vector<LiveAct> acts_of(const JsonPlace& result) {
  std::vector<LiveAct> acts;
  if (!result.has("faults")) return acts;
  for (const JsonPlace& fault : result.at("faults").elements()) {
    const AgentId agent{static_cast<std::uint32_t>(fault.at("agent").whole(most_id))};
    const auto at_ns = static_cast<TimeNs>(std::llround(fault.at("time_s").number() * 1e9));
    if (agent != AgentId{0}) acts.push_back({at_ns, agent, fault.at("action").text()});
  }
  return acts;
}

/// How long messages took in a recorded world, and by which seed.
void read_world(const JsonPlace& world, LiveRun& run) {
  constexpr std::uint64_t longest_ns = 3600'000'000'000;
  run.is_world = true;
  run.seed = world.at("seed").whole(std::numeric_limits<std::uint64_t>::max());
  const JsonPlace latency = world.at("latency_ns");
  const std::vector<JsonPlace> ends = latency.elements();
  if (ends.size() != 2) latency.refuse("two numbers, the least and the most");
  run.latency_ns = {static_cast<TimeNs>(ends[0].whole(longest_ns)),
                    static_cast<TimeNs>(ends[1].whole(longest_ns))};
  if (run.latency_ns.least > run.latency_ns.most) latency.refuse("the least before the most");
}

/// Reads the logs one after another: all must tell of the same mission.
class LifeReader {
 public:
  LifeReader(LiveRun& run, const JsonPlace& result) : run_(run), names_(names_of(result)) {}

  void read(const Path& file) {
    const RunLogReader log(file);
    const json process = log.meta("process");
    const JsonPlace place(process, file.string() + ": meta process");
    LiveLife life;
    life.agent = {static_cast<std::uint32_t>(place.at("agent").whole(most_id))};
    const auto name = names_.find(place.at("pid").whole(most_id));
    life.is_twin = name != names_.end() && name->second.ends_with(", second");
    const auto mission = log.first(log_kind::mission);
    if (!mission) {
      run_.left_out.push_back(
          fmt::format("{}: this life never had the mission", file.filename().string()));
      return;
    }
    const LogSchemas schemas(log);
    schemas.demand_read();
    // What the mission does not have would be made up: another run than this.
    if (schemas.of(log_kind::mission)) schemas.demand_own();
    take(mission_in(mission->body, file), file);
    life.born_ns = mission->t_ns;
    life.last_ns = log.last_ns();
    if (const auto end = log.first(log_kind::end)) {
      const json body = end->json();
      life.ended_by = JsonPlace(body, file.string() + ": end").at("by").text();
    }
    run_.lives.push_back(life);
  }

 private:
  static Mission mission_in(const std::string& bytes, const Path& file) {
    try {
      Mission mission = decode<Mission>(bytes);
      if (const auto problem = misfit(mission)) throw InputError(*problem);
      return mission;
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: mission: {}", file.string(), error.what()));
    }
  }
  void take(Mission mission, const Path& file) {
    if (run_.lives.empty())
      run_.mission = std::move(mission);
    else if (digest(mission) != digest(run_.mission))
      throw InputError(fmt::format("{}: mission {}, but the other logs have {}", file.string(),
                                   hex(digest(mission)), hex(digest(run_.mission))));
  }

  LiveRun& run_;
  std::map<std::uint64_t, std::string> names_;
};

std::vector<AgentId> ids_of(const Mission& mission) {
  std::vector<AgentId> ids;
  for (const Uav& uav : mission.fleet) ids.push_back(uav.id);
  return ids;
}

void check_published(const Path& run, const Mission& mission) {
  const Path file = run / "arcs.json";
  const json document = parsed(file);
  const JsonPlace id = JsonPlace(document, file.string()).at("mission").at("id");
  if (id.hex() != mission.id)
    id.refuse(fmt::format("{}, the mission in the agents' logs", hex(mission.id)));
}

}  // namespace

LiveRun read_run(const Path& directory) {
  LiveRun run;
  const Path result_file = directory / "result.json";
  const json document = parsed(result_file);
  const JsonPlace result(document, result_file.string());
  run.acts = acts_of(result);
  if (result.has("world")) read_world(result.at("world"), run);
  LifeReader reader(run, result);
  for (const Path& file : agents_logs(directory)) reader.read(file);
  if (run.lives.empty())
    throw InputError(
        fmt::format("{}: no agent's log has the mission", (directory / "logs").string()));
  check_published(directory, run.mission);
  std::stable_sort(run.lives.begin(), run.lives.end(),
                   [](const LiveLife& a, const LiveLife& b) { return a.born_ns < b.born_ns; });
  if (result.has("fault_tier") && result.at("fault_tier").text() == "packets")
    run.left_out.push_back("that the faults of links acted on packets: here they act on messages");
  if (result.has("faults") || run.is_world)
    run.schedule = load_faults((directory / "faults.yaml").string(), ids_of(run.mission));
  return run;
}

WorldSpec world_of(const LiveRun& run, std::uint64_t seed) {
  return {
      .seed = seed, .mission = run.mission, .faults = faults_of(run), .latency_ns = run.latency_ns};
}

}  // namespace arcbid
