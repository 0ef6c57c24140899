// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/config.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

const std::filesystem::path source_dir = ARCBID_SOURCE_DIR;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string error_of(const Config& config) {
  try {
    validate(config);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Config, DefaultsAreLegalAndWhatAnEmptyMappingMeans) {
  EXPECT_NO_THROW(validate(Config{}));
  EXPECT_EQ(to_yaml(parse_config("{}", "c.yaml")), to_yaml(Config{}));
  EXPECT_EQ(to_yaml(parse_config("coverage:\n  # spacing_m: 3\n", "c.yaml")), to_yaml(Config{}));
}

TEST(Config, ASensorsKindChoosesWhatIsNotGiven) {
  // Wherever the kind stands: what is given is kept.
  for (const char* text :
       {"coverage: {sensor: {kind: camera, range_m: 6, horizontal_fov_deg: 90}}",
        "coverage: {sensor: {range_m: 6, horizontal_fov_deg: 90, kind: camera}}"}) {
    const Sensor sensor = parse_config(text, "c.yaml").coverage.sensor;
    EXPECT_EQ(sensor.kind, SensorKind::camera);
    EXPECT_EQ(sensor.range_m, 6);
    EXPECT_EQ(sensor.horizontal_fov_deg, 90);
    EXPECT_EQ(sensor.vertical_fov_deg, camera_preset().vertical_fov_deg);
    EXPECT_EQ(sensor.least_range_m, camera_preset().least_range_m);
  }
  const Sensor lidar =
      parse_config(
          "coverage: {sensor: {least_range_m: 1, max_incidence_deg: 60, vertical_fov_deg: 40, "
          "lowest_look_deg: -20, highest_look_deg: 10}}",
          "c.yaml")
          .coverage.sensor;
  EXPECT_EQ(lidar.kind, SensorKind::lidar);
  EXPECT_EQ(lidar.least_range_m, 1);
  EXPECT_EQ(lidar.max_incidence_deg, 60);
  EXPECT_EQ(lidar.vertical_fov_deg, 40);
  EXPECT_EQ(lidar.lowest_look_deg, -20);
  EXPECT_EQ(lidar.highest_look_deg, 10);
  EXPECT_EQ(lidar.horizontal_fov_deg, 360);
}

TEST(Config, EveryKeyReachesItsField) {
  const Config c = parse_config(R"(
name: Old bridge
structure:
  unit: us-ft
  up: y
  parametric: {kind: arch, length_m: 61, width_m: 13, deck_height_m: 14, deck_thickness_m: 1.5,
    piers: 5, pier_width_m: 2.5, girders: 6, girder_depth_m: 1.25, tower_height_m: 31}
coverage: {spacing_m: 3, standoff_m: 4.5, safety_m: 2.5, ground_clearance_m: 1, rows: long_side,
  seed: 9, ground_m: -0.5}
fleet: {agents: 7, speed_mps: 2, endurance_s: 900, payload: camera}
auction: {policy: cbba, score: discounted-insert-warped, discount_per_s: 0.5, split_m: 12, max_tasks: 50,
  bundle_limit: 8, audit_bids: false, tick_ms: 12.5, lease_ms: 3000, barrier_ms: 4000}
tour: {solver: crsom, seed: 11, epochs: 12, iterations: 13}
network: {transport: discovery_server, domain: 17, server_address: 127.0.0.2, server_port: 12,
  interface_address: 127.0.0.3, reliable_bids: true}
timeout_s: 60
)",
                                "c.yaml");
  EXPECT_EQ(c.name, "Old bridge");
  EXPECT_EQ(c.structure.file, std::nullopt);
  EXPECT_EQ(c.structure.unit, "us-ft");
  EXPECT_EQ(c.structure.up, 'y');
  const ParametricBridge& p = c.structure.parametric;
  EXPECT_EQ(p.kind, BridgeKind::arch);
  EXPECT_EQ(p.length_m, 61);
  EXPECT_EQ(p.width_m, 13);
  EXPECT_EQ(p.deck_height_m, 14);
  EXPECT_EQ(p.deck_thickness_m, 1.5);
  EXPECT_EQ(p.piers, 5u);
  EXPECT_EQ(p.pier_width_m, 2.5);
  EXPECT_EQ(p.girders, 6u);
  EXPECT_EQ(p.girder_depth_m, 1.25);
  EXPECT_EQ(p.tower_height_m, 31);
  EXPECT_EQ(c.coverage.spacing_m, 3);
  EXPECT_EQ(c.coverage.standoff_m, 4.5);
  EXPECT_EQ(c.coverage.safety_m, 2.5);
  EXPECT_EQ(c.coverage.ground_clearance_m, 1);
  EXPECT_EQ(c.coverage.rows, RowSide::long_side);
  EXPECT_EQ(c.coverage.seed, 9u);
  EXPECT_EQ(c.coverage.ground_m, -0.5);
  EXPECT_EQ(c.fleet.agents, 7u);
  EXPECT_EQ(c.fleet.speed_mps, 2);
  EXPECT_EQ(c.fleet.endurance_s, 900);
  EXPECT_EQ(c.fleet.payload, Payload::camera);
  EXPECT_EQ(c.auction.policy, PolicyKind::cbba);
  EXPECT_EQ(c.auction.score, ScoreKind::discounted_insert_warped);
  EXPECT_EQ(c.auction.discount_per_s, 0.5);
  EXPECT_EQ(c.auction.split_m, 12);
  EXPECT_EQ(c.auction.max_tasks, 50u);
  EXPECT_EQ(c.auction.bundle_limit, 8u);
  EXPECT_FALSE(c.auction.audit_bids);
  EXPECT_EQ(c.auction.tick_ns, 12'500'000);
  EXPECT_EQ(c.auction.lease_ns, 3'000'000'000);
  EXPECT_EQ(c.auction.barrier_ns, 4'000'000'000);
  EXPECT_EQ(c.tour.seed, 11u);
  EXPECT_EQ(c.tour.epochs, 12u);
  EXPECT_EQ(c.tour.solver, TourSolver::crsom);
  EXPECT_EQ(c.tour.iterations, 13u);
  EXPECT_EQ(c.network.transport, TransportKind::discovery_server);
  EXPECT_EQ(c.network.domain, 17u);
  EXPECT_EQ(c.network.server_address, "127.0.0.2");
  EXPECT_EQ(c.network.server_port, 12);
  EXPECT_EQ(c.network.interface_address, "127.0.0.3");
  EXPECT_TRUE(c.network.reliable_bids);
  EXPECT_EQ(c.timeout_s, 60);
}

TEST(Config, UavsAreSortedCountedAndFlyAtTheFleetsSpeed) {
  const Config c = parse_config(
      "fleet:\n  uavs: [{id: 7, home_m: [1, 2, 3]}, {id: 2, home_m: [4, -0.5, 1e1], speed_mps: "
      "3}]\n"
      "  speed_mps: 2\n",
      "c.yaml");
  ASSERT_EQ(c.fleet.uavs.size(), 2u);
  EXPECT_EQ(c.fleet.agents, 2u);
  EXPECT_EQ(c.fleet.uavs[0].id, AgentId{2});
  EXPECT_EQ(c.fleet.uavs[0].home_m, Vec3(4, -0.5, 10));
  EXPECT_EQ(c.fleet.uavs[0].speed_mps, 3);
  EXPECT_EQ(c.fleet.uavs[1].id, AgentId{7});
  EXPECT_EQ(c.fleet.uavs[1].speed_mps, 2);
}

TEST(Config, UavsHaveTheFleetsLimitsUnlessTheyStateTheirOwn) {
  const Config c = parse_config(
      "fleet:\n"
      "  uavs:\n"
      "  - {id: 1, home_m: [0, 0, 0]}\n"
      "  - {id: 2, home_m: [0, 0, 0], endurance_s: unlimited, payload: any}\n"
      "  - {id: 3, home_m: [0, 0, 0], endurance_s: 20.5, payload: camera}\n"
      "  endurance_s: 900\n"
      "  payload: lidar\n",
      "c.yaml");
  EXPECT_EQ(c.fleet.uavs[0].endurance_s, 900);
  EXPECT_EQ(c.fleet.uavs[0].payload, Payload::lidar);
  EXPECT_EQ(c.fleet.uavs[1].endurance_s, std::nullopt);
  EXPECT_EQ(c.fleet.uavs[1].payload, Payload::any);
  EXPECT_EQ(c.fleet.uavs[2].endurance_s, 20.5);
  EXPECT_EQ(c.fleet.uavs[2].payload, Payload::camera);
  EXPECT_EQ(parse_config("fleet: {endurance_s: unlimited}", "c.yaml").fleet.endurance_s,
            std::nullopt);
}

TEST(Config, AFileIsFoundFromTheConfigsFolder) {
  const Config c =
      parse_config("structure: {file: ../configs/demo.yaml}", source_dir / "docs/c.yaml");
  EXPECT_EQ(c.structure.file, (source_dir / "configs/demo.yaml").lexically_normal());
  EXPECT_EQ(to_yaml(parse_config(to_yaml(c), "/elsewhere/c.yaml")), to_yaml(c));
}

TEST(Config, WordsForNone) {
  const Config c = parse_config(
      "auction: {split_m: shortest_arc}\ncoverage: {ground_m: lowest_point}\nnetwork: {domain: "
      "auto}\nfleet: {uavs: []}",
      "c.yaml");
  EXPECT_EQ(c.auction.split_m, std::nullopt);
  EXPECT_EQ(c.network.domain, std::nullopt);
  EXPECT_TRUE(c.fleet.uavs.empty());
}

TEST(Config, NumbersAsPeopleWriteThem) {
  const Config c = parse_config(
      "coverage: {spacing_m: +3, standoff_m: .5e1, safety_m: 2., seed: 1e3}\n"
      "fleet: {uavs: [{id: 1, home_m: [-0, 0, 0]}]}",
      "c.yaml");
  EXPECT_EQ(c.coverage.spacing_m, 3);
  EXPECT_EQ(c.coverage.standoff_m, 5);
  EXPECT_EQ(c.coverage.safety_m, 2);
  EXPECT_EQ(c.coverage.seed, 1000u);
  EXPECT_FALSE(std::signbit(c.fleet.uavs[0].home_m.x()));
}

TEST(Config, EveryShippedConfigLoadsAndPrintsBackTheSame) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir / "configs")) {
    const bool of_a_run =
        entry.is_regular_file() && !entry.path().stem().string().starts_with("sim");
    if (!of_a_run) continue;
    SCOPED_TRACE(entry.path());
    const Config c = load_config(entry.path());
    EXPECT_NO_THROW(validate(c));
    EXPECT_EQ(to_yaml(parse_config(to_yaml(c), "printed.yaml")), to_yaml(c));
    names.push_back(entry.path().filename());
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"demo.yaml", "cbba.yaml", "discovery_server.yaml"}));
}

TEST(Config, ThePolicyIsAllThatDistinguishesTheComparison) {
  Config demo = load_config(source_dir / "configs/demo.yaml");
  demo.name = "cbba";
  demo.auction.policy = PolicyKind::cbba;
  EXPECT_EQ(to_yaml(load_config(source_dir / "configs/cbba.yaml")), to_yaml(demo));
}

TEST(Config, TheReferenceInTheDocsIsTheGeneratedOne) {
  EXPECT_THAT(text_of(source_dir / "docs/CONFIG.md"), HasSubstr("\n\n" + config_reference()))
      << "put this table into docs/CONFIG.md:\n"
      << config_reference();
}

TEST(Config, TheReferenceIsATableOfFourColumns) {
  std::istringstream lines(config_reference());
  int rows = 0;
  for (std::string line; std::getline(lines, line); ++rows)
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 5) << line;
  EXPECT_GT(rows, 40);
  EXPECT_THAT(config_reference(),
              HasSubstr("| `fleet.speed_mps` | a number in [0.1, 30] | `1` | "));
}

TEST(Validate, RangesOfFieldsSetByHand) {
  Config c;
  c.fleet.agents = 0;
  c.fleet.speed_mps = std::nan("");
  c.auction.split_m = 0.001;
  c.name = "a/b";
  EXPECT_EQ(error_of(c),
            "name: \"a/b\" is not 1 to 64 printable characters without / or \\\n"
            "fleet.agents: 0 is outside [1, 64]\n"
            "fleet.speed_mps: nan is not a number in [0.1, 30]\n"
            "auction.split_m: 0.001 is outside [0.1, 10000]");
}

TEST(Validate, WhatMustGoTogether) {
  Config c;
  c.coverage.safety_m = 5;
  c.fleet.uavs = {{AgentId{1}, Vec3::Zero(), 1}, {AgentId{1}, Vec3::Zero(), 1}};
  c.structure.file = "/no/such/bridge.ply";
  EXPECT_EQ(error_of(c),
            "structure.file: no such file: /no/such/bridge.ply\n"
            "coverage.safety_m: 5 is too near coverage.standoff_m, 4; at most 3.636 is legal\n"
            "fleet.agents: 4, but fleet.uavs lists 2; leave one of the two out\n"
            "fleet.uavs[1].id: 1 is the id of fleet.uavs[0] already");
}

}  // namespace
}  // namespace arcbid
