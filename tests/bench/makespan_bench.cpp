// SPDX-License-Identifier: GPL-3.0-or-later
// How near auction and exchanges come to the best makespans known, on all instances of
// ../shared/data/makespan: ratios to the best one without cutting arcs, and CPU in one thread.
//
//   makespan_bench     tables in Markdown on standard output
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/auction/arc_instance.hpp"
#include "sim/auction/fleet_run.hpp"

namespace {

using namespace arcbid;
namespace fs = std::filesystem;

const fs::path data = fs::path(ARCBID_SHARED_DATA) / "makespan";

struct Method {
  const char* name;
  ScoreKind score;
  double split_m;
  TradesKind trades;
};
constexpr double whole_m = 1e9;
constexpr Method methods[] = {
    {"minimax", ScoreKind::minimax, whole_m, TradesKind::off},
    {"long first", ScoreKind::minimax_long_first, whole_m, TradesKind::off},
    {"long first, split at 10 m", ScoreKind::minimax_long_first, 10, TradesKind::off},
    {"long first, cheap trades", ScoreKind::minimax_long_first, whole_m, TradesKind::cheap},
    {"long first, full trades", ScoreKind::minimax_long_first, whole_m, TradesKind::full},
    {"long first, split at 10 m, full trades", ScoreKind::minimax_long_first, 10, TradesKind::full},
};

struct Sum {
  double mean = 0, worst = 0;
  void add(double value, std::size_t of) {
    mean += value / static_cast<double>(of);
    worst = std::max(worst, value);
  }
};

nlohmann::json run(const Method& method, const std::string& name) {
  Mission mission = read_arc_instance(data / (name + ".json"));
  mission.auction.score = method.score;
  mission.auction.split_m = method.split_m;
  return nlohmann::json::parse(to_json(run_fleet(mission, Graph::complete, method.trades)));
}

double best_s(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(data / (name + ".best.json")))["unsplit"]["makespan"];
}

void print_row(const Method& method, const std::set<std::string>& names) {
  Sum ratio, cv, trades_s, fleet_s;
  for (const std::string& name : names) {
    const auto result = run(method, name);
    ratio.add(result["makespan_s"].get<double>() / best_s(name), names.size());
    cv.add(result["cv_time"], names.size());
    trades_s.add(result["cpu"]["trades_agent_s"], names.size());
    fleet_s.add(result["cpu"]["fleet_s"], names.size());
  }
  fmt::print("| {} | {:.4f} | {:.4f} | {:.4f} | {:.3f} / {:.3f} | {:.3f} / {:.3f} |\n", method.name,
             ratio.mean, ratio.worst, cv.mean, trades_s.mean, trades_s.worst, fleet_s.mean,
             fleet_s.worst);
}

}  // namespace

int main() {
  std::set<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(data, none)) {
    const std::string file = entry.path().filename().string(), end = ".best.json";
    if (file.ends_with(end)) names.insert(file.substr(0, file.size() - end.size()));
  }
  if (names.empty()) {
    fmt::print("{} is not there: nothing to measure\n", data.string());
    return 0;
  }
  fmt::print(
      "| {} instances | makespan, mean | worst | CV of times | CPU s of an agent's exchanges, mean "
      "/ "
      "worst | CPU s of the whole fleet |\n|---|---|---|---|---|---|\n",
      names.size());
  for (const Method& method : methods) print_row(method, names);
  fmt::print("\n| instance | best known, s | long first | cheap | full |\n|---|---|---|---|---|\n");
  for (const std::string& name : names) {
    fmt::print("| {} | {:.1f} |", name, best_s(name));
    for (const int method : {1, 3, 4})
      fmt::print(" {:.4f} |",
                 run(methods[method], name)["makespan_s"].get<double>() / best_s(name));
    fmt::print("\n");
  }
  return 0;
}
