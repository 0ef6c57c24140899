// SPDX-License-Identifier: GPL-3.0-or-later
// The makespan that auction and exchanges reach on instances whose best known ones are on file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "sim/auction/arc_instance.hpp"
#include "sim/auction/fleet_run.hpp"

namespace arcbid {
namespace {

namespace fs = std::filesystem;
const fs::path data = fs::path(ARCBID_SHARED_DATA) / "makespan";

struct Ratios {
  double mean = 0, worst = 0;
  std::size_t count = 0;
};

/// Of makespans to the best ones known without cutting arcs.
Ratios ratios(TradesKind trades) {
  Ratios ratios;
  for (const auto& entry : fs::directory_iterator(data)) {
    const std::string best = entry.path().string();
    const std::string end = ".best.json";
    if (!best.ends_with(end)) continue;
    const auto known = nlohmann::json::parse(std::ifstream(best))["unsplit"]["makespan"];
    Mission mission = read_arc_instance(best.substr(0, best.size() - end.size()) + ".json");
    mission.auction.score = ScoreKind::minimax_long_first;
    mission.auction.split_m = 1e9;
    const auto run = nlohmann::json::parse(to_json(run_fleet(mission, Graph::complete, trades)));
    EXPECT_EQ(run["unassigned"], 0);
    const double ratio = run["makespan_s"].get<double>() / known.get<double>();
    ratios.mean += ratio;
    ratios.worst = std::max(ratios.worst, ratio);
    ++ratios.count;
  }
  ratios.mean /= static_cast<double>(ratios.count);
  return ratios;
}

TEST(Instances, AuctionAndCheapExchangesComeNearTheBestKnown) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const Ratios auction = ratios(TradesKind::off), cheap = ratios(TradesKind::cheap);
  EXPECT_EQ(cheap.count, 20u);
  EXPECT_LE(auction.mean, 1.135);
  EXPECT_LE(auction.worst, 1.30);
  EXPECT_LE(cheap.mean, 1.06);
  EXPECT_LE(cheap.worst, 1.12);
}

TEST(Instances, AreRefusedByWhatIsWrongInThem) {
  const fs::path file = fs::path(testing::TempDir()) / "instance.json";
  const auto refusal = [&](const std::string& text) -> std::string {
    std::ofstream(file) << text;
    try {
      read_arc_instance(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  const std::string arcs = R"("arcs": [[[0,0,0],[1,0,0]]])";
  EXPECT_NE(refusal("{").find("not JSON"), std::string::npos);
  EXPECT_NE(refusal("{" + arcs + "}").find("agents: is missing"), std::string::npos);
  EXPECT_NE(refusal(R"({"agents": [], )" + arcs + "}").find("agents: is not a list of 1 to"),
            std::string::npos);
  EXPECT_NE(
      refusal(R"({"agents": [{"home": [0,0]}], )" + arcs + "}").find("agents[0].home: is not"),
      std::string::npos);
  EXPECT_NE(refusal(R"({"agents": [{"home": [0,0,0], "speed_mps": 0}], )" + arcs + "}")
                .find("agents[0].speed_mps: 0 is not above 0"),
            std::string::npos);
  const std::string agents = R"({"agents": [{"home": [0,0,0]}], "arcs": )";
  EXPECT_NE(refusal(agents + "[[[0,0,0],[0,0,0]]]}").find("arcs[0]: has fewer than two distinct"),
            std::string::npos);
  EXPECT_NE(
      refusal(agents + R"([[[0,0,0],[0,"x",0]]]})").find(R"(arcs[0][1]: "x" is not a number)"),
      std::string::npos);
  EXPECT_EQ(refusal(agents + "[[[0,0,0],[1,0,0]]]}"), "none");
  EXPECT_NE(refusal(R"({"agents": [{"home": [0,0,0], "endurance_s": -1}], )" + arcs + "}")
                .find("agents[0].endurance_s: -1 is not above 0"),
            std::string::npos);
  EXPECT_NE(refusal(agents + R"([{"points": [[0,0,0],[1,0,0]], "payload": "nose"}]})")
                .find(R"(arcs[0].payload: "nose" is not one of any, lidar, camera)"),
            std::string::npos);
}

TEST(Instances, MayHaveLimitsAndSayWhatIsLeft) {
  const fs::path file = fs::path(testing::TempDir()) / "limits.json";
  std::ofstream(file) << R"({
    "agents": [{"home": [0,0,0], "endurance_s": 41, "payload": "lidar"},
               {"home": [0,0,0], "speed_mps": 2, "endurance_s": 20}],
    "arcs": [[[10,0,0],[20,0,0]], {"points": [[10,0,0],[10,10,0]], "payload": "camera"},
             [[0,50,0],[0,60,0]]]})";
  Mission mission = read_arc_instance(file);
  mission.auction.split_m = 1e9;
  const FleetRun run = run_fleet(mission, Graph::complete, TradesKind::off);
  EXPECT_EQ(run.unassigned, 1u);
  ASSERT_EQ(run.left.size(), 1u);
  EXPECT_EQ(to_text(run.left[0]),
            "arc 2, 0.0 to 10.0 m: no bidder: needs 60.0 s, best endurance "
            "20.0 s (agent 2)");
  EXPECT_NE(to_json(run).find(R"("no_bidders":["arc 2, )"), std::string::npos);
  EXPECT_LE(run.times_s[0], 41);
  EXPECT_EQ(run.routes[1].size(), 1u);
  EXPECT_EQ(run.routes[1][0].arc, 1u) << "only agent 2 has a camera";
}

}  // namespace
}  // namespace arcbid
