// SPDX-License-Identifier: GPL-3.0-or-later
// What an auction costs: rounds, messages and CPU to proven agreement, in virtual time with 1 to 5
// ms links, all agents in one thread. Without arguments: the built-in bridge and the third-party
// ones that are at hand.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "core/io/mission/mission_plan.hpp"
#include "tests/auction/fleet.hpp"

namespace {

using namespace arcbid;

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void measure(const std::string& name, const Config& config) {
  const MissionPlan plan = plan_mission(config, 1);
  const double before = cpu_s();
  testing::Fleet fleet(plan.mission, {}, 1);
  const bool agreed = fleet.run(600'000'000'000);
  const double cpu = cpu_s() - before;
  std::uint32_t rounds = 0;
  double longest_s = 0;
  for (const AgentId id : fleet.living()) {
    if (!agreed) continue;
    rounds = std::max(rounds, fleet.agreement(id)->round);
    for (const Uav& uav : plan.mission.fleet)
      if (uav.id == id) {
        double worst = 0;
        for (std::size_t j = 0; j < fleet.agreement(id)->winners.size(); ++j)
          if (fleet.agreement(id)->winners[j].winner == id)
            worst = std::min(worst, fleet.agreement(id)->winners[j].bid);
        longest_s = std::max(longest_s, -worst);
      }
  }
  fmt::print("{:<32} {:>3} {:>5} {:>6} {:>7} {:>9.2f} {:>9} {:>8.2f} {:>10.1f}\n", name,
             config.fleet.agents, plan.mission.arcs.size(), fleet.agent({1}).tasks().tasks.size(),
             rounds, static_cast<double>(fleet.now_ns()) * 1e-9, fleet.messages(), cpu, longest_s);
}

}  // namespace

int main() {
  fmt::print("{:<32} {:>3} {:>5} {:>6} {:>7} {:>9} {:>9} {:>8} {:>10}\n", "structure", "N", "arcs",
             "tasks", "rounds", "virtual_s", "messages", "cpu_s", "makespan_s");
  const Config demo = load_config(std::string(ARCBID_SOURCE_DIR) + "/configs/demo.yaml");
  for (const std::uint32_t agents : {2u, 4u, 6u, 16u}) {
    Config config = demo;
    config.fleet.agents = agents;
    measure("demo", config);
    for (const auto& [file, unit] :
         std::vector<std::pair<std::string, std::string>>{{"truss_span_48m.ply", "m"},
                                                          {"quinte_skyway.stl", "m"},
                                                          {"duluth_aerial_lift_bridge.obj", "m"},
                                                          {"gazebo_truss_bridge.ply", "m"},
                                                          {"gazebo_cloverleaf_inches.obj", "in"},
                                                          {"girder_bridge_cloud.pcd", "m"}}) {
      config.structure.file = std::string(ARCBID_SHARED_DATA) + "/geometry/bridges/" + file;
      config.structure.unit = unit;
      if (std::filesystem::exists(*config.structure.file)) measure(file, config);
    }
  }
}
