// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacle models and legs in them: what a model weighs, what all lengths among 600 end points
// take, how many straight legs would have collided, and how much longer legs are than what a search
// over all cells gives.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <queue>
#include <string>
#include <utility>

#include "core/airspace/obstacle_transit.hpp"
#include "core/airspace/pull.hpp"
#include "core/airspace/surroundings.hpp"
#include "core/io/structure_reader.hpp"
#include "core/structure/parametric.hpp"

namespace arcbid {
namespace {

/// Of all threads: the same whatever else the machine does.
double now_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// End points of pieces of all arcs, as a mission of about `count` tasks would have them.
std::vector<Vec3> end_points(const std::vector<Arc>& arcs, std::size_t count) {
  double total_m = 0;
  for (const Arc& arc : arcs) total_m += length_m(arc.waypoints);
  const double piece_m = total_m / static_cast<double>(count - arcs.size());
  std::vector<Vec3> out;
  for (const Arc& arc : arcs) {
    const double all_m = length_m(arc.waypoints);
    out.push_back(arc.waypoints.front().position_m);
    for (double at_m = piece_m; at_m < all_m && out.size() < count; at_m += piece_m)
      out.push_back(part(arc.waypoints, at_m - piece_m, at_m).back().position_m);
  }
  return out;
}

/// Dijkstra over the 26 neighbours of every cell, from one cell.
std::vector<std::uint32_t> cell_tree(const FreeGrid& grid, const Cell& source) {
  constexpr std::uint32_t none = UINT32_MAX;
  const Cell size = grid.size();
  const std::size_t total = grid.number({0, 0, size[2]});
  std::vector<float> length(total, 1e30f);
  std::vector<std::uint32_t> from(total, none);
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto start = static_cast<std::uint32_t>(grid.number(source));
  length[start] = 0;
  from[start] = start;
  open.emplace(0.0f, start);
  const std::array<float, 4> steps{0, 1, std::sqrt(2.0f), std::sqrt(3.0f)};
  while (!open.empty()) {
    const auto [here, n] = open.top();
    open.pop();
    if (here > length[n]) continue;
    const int x = static_cast<int>(n) % size[0], y = static_cast<int>(n) / size[0] % size[1],
              z = static_cast<int>(n) / (size[0] * size[1]);
    for (int k = 0; k < 27; ++k) {
      const Cell c{x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1};
      if (!grid.holds(c) || !grid.free(c)) continue;
      const auto m = static_cast<std::uint32_t>(grid.number(c));
      const int moved = (c[0] != x) + (c[1] != y) + (c[2] != z);
      const float next = here + steps[static_cast<std::size_t>(moved)];
      if (next >= length[m]) continue;
      length[m] = next;
      from[m] = n;
      open.emplace(next, m);
    }
  }
  return from;
}

/// Ratio of the legs' lengths to those of pulled ways over cells, of legs that are not straight.
struct Ratio {
  double mean = 0, worst = 0;
  std::size_t legs = 0;
};

Ratio against_cells(const ObstacleTransit& transit, const std::vector<Vec3>& places) {
  const FreeGrid& grid = transit.grid();
  Ratio out;
  for (std::size_t s = 0; s < places.size(); s += std::max<std::size_t>(1, places.size() / 8)) {
    if (!grid.free(places[s]) || !grid.inside(places[s])) continue;
    const auto from = cell_tree(grid, grid.cell(places[s]));
    for (std::size_t t = 0; t < places.size(); t += 7) {
      if (!grid.free(places[t]) || grid.sees(places[s], places[t]) ||
          grid.sees(places[t], places[s]))
        continue;
      std::vector<Vec3> way{places[t]};
      auto n = static_cast<std::uint32_t>(grid.number(grid.cell(places[t])));
      for (;; n = from[n]) {
        const int at = static_cast<int>(n);
        way.push_back(grid.centre({at % grid.size()[0], at / grid.size()[0] % grid.size()[1],
                                   at / (grid.size()[0] * grid.size()[1])}));
        if (from[n] == n) break;
      }
      way.push_back(places[s]);
      pull(grid, way);
      const double ratio = transit.length_m(places[s], places[t]) / way_length_m(way);
      out.mean += ratio;
      out.worst = std::max(out.worst, ratio);
      ++out.legs;
    }
  }
  if (out.legs > 0) out.mean /= static_cast<double>(out.legs);
  return out;
}

void report(const std::string& name, const Structure& structure) {
  const CoverageSettings settings;
  ArcPlan plan = bridge_arcs(structure, settings);
  const double begun_s = now_s();
  const Surroundings surroundings(structure, settings);
  const double covered_s = now_s();
  std::vector<std::string> warnings;
  const Airspace airspace = surroundings.airspace(plan.arcs, warnings);
  const double built_s = now_s();
  const std::vector<Vec3> places = end_points(plan.arcs, 600);
  const double asked_s = now_s();
  const ObstacleTransit none(airspace, plan.arcs, {});
  const double ready_s = now_s();
  const ObstacleTransit transit(airspace, plan.arcs, places);
  const double done_s = now_s();
  std::size_t collide = 0, pairs = 0, in_cells = 0;
  for (const Vec3& p : places) in_cells += transit.grid().free(p);
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size(); ++b, ++pairs)
      collide += !transit.grid().sees(places[a], places[b]);
  const Ratio ratio = against_cells(transit, places);
  fmt::print(
      "{:<22} {:>5.2f} m x {:>8} {:>7} B {:>5.2f} {:>5.2f} s {:>5} {:>5} {:>5.1f} % {:>6.3f} "
      "{:>6.3f} s {:>6.4f} {:>6.4f} ({}) acc {} closed {}\n",
      name, airspace.cell_m, airspace.cells[0] * airspace.cells[1] * airspace.cells[2],
      airspace.runs.size(), covered_s - begun_s, built_s - covered_s, places.size(), in_cells,
      100.0 * static_cast<double>(collide) / static_cast<double>(pairs), ready_s - asked_s,
      done_s - ready_s, ratio.mean, ratio.worst, ratio.legs, airspace.accesses.size(),
      transit.closed_in().size());
  for (const std::string& warning : warnings) fmt::print("  {}\n", warning);
  std::fflush(stdout);
}

void report_file(const char* file, const char* unit = "m") {
  const auto path = std::filesystem::path(ARCBID_SHARED_DATA) / "geometry" / file;
  if (!std::filesystem::exists(path)) {
    fmt::print("{}: is not here\n", file);
    return;
  }
  report(path.stem().string(), read_structure(path, {.unit = unit}).structure);
}

}  // namespace
}  // namespace arcbid

int main() {
  using namespace arcbid;
  fmt::print(
      "structure; cell x cells; bytes of runs; s to cover and build; end points, of them in "
      "free cells; straight legs that collide; s to unpack, and with all lengths; length "
      "against cells, mean and worst (legs). Seconds are CPU seconds, of all threads.\n");
  ParametricBridge bridge;
  report("girder bridge 60 m", generate(bridge));
  bridge.length_m = 200;
  bridge.piers = 9;
  report("girder bridge 200 m", generate(bridge));
  report_file("bridges/truss_span_48m.ply");
  report_file("bridges/duluth_aerial_lift_bridge.obj");
  report_file("bridges/gazebo_truss_bridge.ply");
  report_file("bridges/quinte_skyway.stl");
  report_file("bridges/gazebo_cloverleaf_inches.obj", "in");
  report_file("bridges/girder_bridge_cloud.pcd");
  report_file("aircraft/a380.ply");
  return 0;
}
