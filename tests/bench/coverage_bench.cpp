// SPDX-License-Identifier: GPL-3.0-or-later
// What coverage_arcs does on structures of known size, and what it takes: seconds, memory, arcs,
// metres, and coverage on samples of its own. `coverage_bench [FILE…]`; without files: the shared
// structures and clouds of parametric bridges. `--camera`: as a camera sees. `--girders`: the
// bridges alone. `--10m`: ten million points too. `--threads N`: N threads.
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/coverage/coverage_arcs.hpp"
#include "core/io/structure_reader.hpp"
#include "core/structure/parametric.hpp"
#include "tests/coverage_plan/held_out.hpp"

namespace arcbid {
namespace {

using Clock = std::chrono::steady_clock;

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of all threads: what the machine's other work does not change.
double cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * usage.ru_utime.tv_usec;
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void measure(const std::string& name, const Structure& structure, CoverageSettings settings) {
  CoverageSettings plain = settings;
  plain.fill = plain.trim = false;
  try {
    auto start = Clock::now();
    coverage_arcs(structure, plain);
    const double plain_s = since_s(start);
    start = Clock::now();
    const double cpu_before = cpu_s();
    const ArcPlan plan = coverage_arcs(structure, settings);
    const double s = since_s(start), cpu = cpu_s() - cpu_before;
    const PlannedCoverage& p = plan.planned;
    start = Clock::now();
    const HeldOut held = held_out(structure, plan.arcs, settings);
    fmt::print(
        "{:28} {:8} {:7.2f} {:7.2f} {:7.2f} {:6.0f} {:5} {:7.0f} {:7.0f} {:7.0f} {:8} {:5.1f} "
        "{:7.2f} "
        "{:8.3f} {:6.1f} {:7.3f}\n",
        name, structure.points.size(), plain_s, s, cpu, peak_mib(), plan.arcs.size(), p.base_m,
        p.filled_m, p.planned_m, p.samples, 100.0 * p.visible / std::max<double>(1, p.samples),
        100.0 * p.covered_by_base / std::max<double>(1, p.visible), 100 * held.share(),
        since_s(start), held.least_clearance_m);
    for (const std::string& warning : plan.warnings) fmt::print("    {}\n", warning);
  } catch (const std::exception& error) {
    fmt::print("{:28} {}\n", name, error.what());
  }
  std::fflush(stdout);
}

Structure cloud_of(double length_m, std::size_t points) {
  ParametricBridge bridge;
  bridge.length_m = length_m;
  const Structure mesh = generate(bridge);
  double area_m2 = static_cast<double>(surface_samples(mesh, 0.5, 1).size()) * 0.25;
  Structure cloud;
  cloud.points = surface_samples(mesh, std::sqrt(area_m2 / static_cast<double>(points)), 7);
  return cloud;
}

void shared_structures(const CoverageSettings& settings) {
  const std::filesystem::path folder = std::filesystem::path(ARCBID_SHARED_DATA) / "geometry";
  for (const auto& [name, unit] : std::vector<std::pair<std::string, std::string>>{
           {"bridges/truss_span_48m.ply", "m"},
           {"bridges/quinte_skyway.stl", "m"},
           {"bridges/duluth_aerial_lift_bridge.obj", "m"},
           {"bridges/gazebo_truss_bridge.ply", "m"},
           {"bridges/gazebo_cloverleaf_inches.obj", "in"},
           {"bridges/girder_bridge_cloud.pcd", "m"},
           {"aircraft/a380.ply", "m"},
           {"aircraft/atr72.obj", "m"},
           {"aircraft/dr400.stl", "m"},
           {"structures/fcplanner_pipe_ascii.pcd", "m"},
           {"structures/fcplanner_tianqin_compressed.pcd", "m"},
           {"structures/caric_crane_dense.pcd", "m"}}) {
    if (!std::filesystem::exists(folder / name)) continue;
    measure(std::filesystem::path(name).stem().string().substr(0, 28),
            read_structure(folder / name, {.unit = unit}).structure, settings);
  }
}

}  // namespace
}  // namespace arcbid

int main(int argc, char** argv) {
  using namespace arcbid;
  CoverageSettings settings;
  bool most = false, files = false, shared = true;
  fmt::print(
      "{:28} {:>8} {:>7} {:>7} {:>7} {:>6} {:>5} {:>7} {:>7} {:>7} {:>8} {:>5} {:>7} {:>8} {:>6} "
      "{:>7}\n",
      "structure", "points", "base s", "plan s", "CPU s", "MiB", "arcs", "base m", "fill m",
      "plan m", "samples", "vis %", "base %", "held %", "chk s", "clear m");
  for (int a = 1; a < argc; ++a) {
    const std::string word = argv[a];
    if (word == "--camera") {
      settings.sensor = camera_preset();
    } else if (word == "--10m") {
      most = true;
    } else if (word == "--girders") {
      shared = false;
    } else if (word == "--threads" && a + 1 < argc) {
      settings.threads = static_cast<unsigned>(std::stoul(argv[++a]));
    } else {
      files = true;
      const std::size_t colon = word.rfind(':');
      measure(std::filesystem::path(word).stem().string(),
              read_structure(word.substr(0, colon),
                             {.unit = colon == std::string::npos ? "m" : word.substr(colon + 1)})
                  .structure,
              settings);
    }
  }
  if (files) return 0;
  if (shared) shared_structures(settings);
  measure("girder 60 m, 10 k", cloud_of(60, 10'000), settings);
  measure("girder 60 m, 100 k", cloud_of(60, 100'000), settings);
  measure("girder 200 m, 1 M", cloud_of(200, 1'000'000), settings);
  if (most) measure("girder 400 m, 10 M", cloud_of(400, 10'000'000), settings);
  return 0;
}
