// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/io/config/make_key.hpp"

namespace arcbid::yaml {
namespace {

Kind<AgentId> agent_id() {
  const Kind<std::uint32_t> plain = number<std::uint32_t>(1, 65535);
  return {
      plain.legal,
      [=](const Place& place, AgentId& id, Report& report) { plain.read(place, id.value, report); },
      [=](const AgentId& id) { return plain.print(id.value); }};
}

Kind<std::optional<double>> endurance() {
  return number_or<double>("unlimited", 1, 1e6);
}

Uav read_uav(const YAML::Node& node, const std::string& path, Report& report) {
  Uav uav;
  if (node.IsMap())
    read_mapping({node, node.Mark(), path}, uav_keys(), uav, report);
  else
    report.problem(node.Mark(), path, "is not a mapping such as {id: 1, home_m: [0, 0, 0]}");
  return uav;
}

std::string print_uav(const Uav& uav) {
  std::string line;
  for (const Key<Uav>& k : uav_keys())
    line += fmt::format("{}{}: {}", line.empty() ? "" : ", ", k.name, k.print(uav));
  return "{" + line + "}";
}

Kind<std::vector<Uav>> uav_list() {
  const std::string legal = fmt::format("a list of up to {} UAVs", most_agents);
  return {
      legal,
      [=](const Place& place, std::vector<Uav>& uavs, Report& report) {
        if (!place.node.IsSequence()) {
          if (is_scalar(place, legal, report))
            report.problem(place.at, place.path,
                           fmt::format("{} is not {}", shown(place.node), legal));
        } else if (place.node.size() > most_agents) {
          report.problem(place.at, place.path,
                         fmt::format("a list of {} is not {}", place.node.size(), legal));
        } else {
          for (std::size_t i = 0; i < place.node.size(); ++i)
            uavs.push_back(read_uav(place.node[i], fmt::format("{}[{}]", place.path, i), report));
        }
      },
      [](const std::vector<Uav>& uavs) {
        std::string lines;
        for (const Uav& uav : uavs) lines += "\n    - " + print_uav(uav);
        return uavs.empty() ? "[]" : lines;
      }};
}

}  // namespace

Keys<FleetConfig> fleet_keys() {
  using F = FleetConfig;
  return {
      key("agents", &F::agents, number<std::uint32_t>(1, most_agents),
          "Number of UAVs, placed in a row on the ground beside the structure."),
      key("agents_per_process", &F::agents_per_process, number<std::uint32_t>(1, most_agents),
          "How many UAVs share a process when one launcher starts all: more than 1 where a machine "
          "cannot carry a process for each (64 on two cores: 8)."),
      key("speed_mps", &F::speed_mps, number<double>(0.1, 30),
          "Speed of every UAV that does not state its own."),
      key("endurance_s", &F::endurance_s, endurance(),
          "Longest flight, home to home, of every UAV that does not state its own. Nobody bids for "
          "what it cannot fly within that; see THEORY.md."),
      key("payload", &F::payload, choice(enumerators<Payload>(payload_names)),
          "What every UAV carries that does not state its own; `any`: whatever is needed. Arcs "
          "need "
          "what `coverage.sensor.kind` says."),
      key("uavs", &F::uavs, uav_list(),
          "UAVs with their homes, in place of `fleet.agents`. Empty: the row."),
  };
}

const Keys<Uav>& uav_keys() {
  static const Keys<Uav> keys = {
      required(key("id", &Uav::id, agent_id(), "Names the UAV; distinct.")),
      required(key("home_m", &Uav::home_m, position(1e6), "Where it starts and ends.")),
      key("speed_mps", &Uav::speed_mps, number<double>(0.1, 30), "Its speed."),
      key("endurance_s", &Uav::endurance_s, endurance(), "Its longest flight, home to home."),
      key("payload", &Uav::payload, choice(enumerators<Payload>(payload_names)),
          "What it carries."),
  };
  return keys;
}

}  // namespace arcbid::yaml
