// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/checker/valid_run.hpp"

#include <unistd.h>

#include <fstream>
#include <sstream>

namespace arcbid {

namespace {

// Arc 0 is an L of 20 m, cut at 7.5 m and 15 m, both inside a segment; arc 1 is straight.
constexpr const char* kArcs = R"({
  "schema": 1,
  "mission": {"id": "5eed", "name": "two arcs"},
  "frame": "local East-North-Up, metres",
  "fleet": [{"agent": 1, "home_m": [10, 5, 0], "speed_mps": 2.0},
            {"agent": 2, "home_m": [22, 10, 0], "speed_mps": 1.0}],
  "arcs": [
    {"arc": 0, "kind": "outline", "length_m": 20.0, "waypoints": [
      [0, 0, 10, 0, 1, 0], [10, 0, 10, 0.6, 0.8, 0], [10, 10, 10, 1, 0, 0]]},
    {"arc": 1, "kind": "top_row", "length_m": 10.0, "waypoints": [
      [22, 10, 10, 0, 0, -1], [12, 10, 10, 0, 0, -1]]}]
})";

constexpr const char* kAgreement = R"({
  "view_hash": "cafe", "round": 7, "time_s": 0.8, "members": [1, 2],
  "tasks": [
    {"task": 0, "arc": 0, "from_m": 0.0, "to_m": 7.5, "owner": 1, "bid": -40.5},
    {"task": 1, "arc": 0, "from_m": 7.5, "to_m": 15.0, "owner": 1, "bid": -33.25},
    {"task": 2, "arc": 0, "from_m": 15.0, "to_m": 20.0, "owner": 2, "bid": -43.4},
    {"task": 3, "arc": 1, "from_m": 0.0, "to_m": 10.0, "owner": 2, "bid": -30.0}]
})";

// Backwards from the middle of arc 0's second segment to its first waypoint.
constexpr const char* kRoute1 = R"({
  "length_m": 40.0, "time_s": 20.0, "legs": [
    {"kind": "transit", "waypoints": [[10, 5, 0, 1, 0, 0], [10, 5, 10, 1, 0, 0]]},
    {"kind": "arc", "arc": 0, "from_m": 15.0, "to_m": 0.0, "waypoints": [
      [10, 5, 10, 0.8, 0.6, 0], [10, 0, 10, 0.6, 0.8, 0], [0, 0, 10, 0, 1, 0]]},
    {"kind": "transit", "waypoints": [[0, 0, 10, 0, 1, 0], [10, 5, 0, 0, 1, 0]]}]
})";

constexpr const char* kRoute2 = R"({
  "length_m": 43.401219466856727, "time_s": 43.401219466856727, "legs": [
    {"kind": "transit", "waypoints": [[22, 10, 0, 1, 0, 0], [22, 10, 10, 1, 0, 0]]},
    {"kind": "arc", "arc": 1, "from_m": 0.0, "to_m": 10.0, "waypoints": [
      [22, 10, 10, 0, 0, -1], [12, 10, 10, 0, 0, -1]]},
    {"kind": "transit", "waypoints": [[12, 10, 10, 0, 0, -1], [10, 10, 10, 1, 0, 0]]},
    {"kind": "arc", "arc": 0, "from_m": 20.0, "to_m": 15.0, "waypoints": [
      [10, 10, 10, 1, 0, 0], [10, 5, 10, 0.8, 0.6, 0]]},
    {"kind": "transit", "waypoints": [[10, 5, 10, 1, 0, 0], [22, 10, 0, 1, 0, 0]]}]
})";

nlohmann::json agent(int id, const char* route) {
  return {{"schema", 1},
          {"agent", id},
          {"mission", "5eed"},
          {"agreement", nlohmann::json::parse(kAgreement)},
          {"route", nlohmann::json::parse(route)}};
}

}  // namespace

RunDocuments valid_run() {
  return {nlohmann::json::parse(kArcs), agent(1, kRoute1), agent(2, kRoute2)};
}

RunFolder::RunFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "arcbid_run_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

RunFolder::~RunFolder() {
  std::filesystem::remove_all(path_);
}

void RunFolder::write(const RunDocuments& documents) const {
  write_text("arcs.json", documents.arcs.dump());
  write_text("routes/agent_1.json", documents.agent_1.dump());
  write_text("routes/agent_2.json", documents.agent_2.dump());
}

void RunFolder::write_text(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name) << text;
}

std::string RunFolder::read_text(const std::string& name) const {
  std::ostringstream text;
  text << std::ifstream(path_ / name).rdbuf();
  return text.str();
}

std::string verdicts(const CheckReport& report) {
  return {report.conflict_free ? 'C' : '-', report.complete ? 'c' : '-',
          report.arcs_conserved ? 'A' : '-', report.routes_valid ? 'R' : '-'};
}

std::string listed(const CheckReport& report) {
  std::string lines;
  for (const std::string& problem : report.problems) lines += problem + "\n";
  return lines;
}

}  // namespace arcbid
