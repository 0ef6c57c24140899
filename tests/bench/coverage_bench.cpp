// SPDX-License-Identifier: GPL-3.0-or-later
// What coverage_arcs does on structures of known size, and what it takes: seconds, memory, arcs,
// metres, and what the certificate says of the arcs, which shares no code or samples with it.
// `coverage_bench [FILE…]`; without files: the shared structures and clouds of parametric bridges.
// `--camera`: as a camera sees. `--girders`: the bridges alone. `--10m`: ten million points too.
// `--threads N`: N threads.
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
#include "sim/certificate/certificate.hpp"

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

/// As if the arcs alone were flown: the bench is about them, not about the legs between them.
certificate::Certificate certified(const Structure& structure, const std::vector<Arc>& arcs,
                                   const CoverageSettings& settings) {
  certificate::Settings how;
  how.sensor = settings.sensor;
  how.safety_m = settings.safety_m;
  how.ground_clearance_m = settings.ground_clearance_m;
  how.ground_m = settings.ground_m;
  how.threads = settings.threads;
  certificate::Flown flown;
  flown.flights.push_back({1, {}});
  for (const Arc& arc : arcs) {
    flown.arcs.push_back(arc.waypoints);
    flown.flights.back().legs.push_back({arc.id.value, arc.waypoints});
  }
  return certificate::certify(structure, flown, how);
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
    const certificate::Certificate held = certified(structure, plan.arcs, settings);
    const double certificate_s = since_s(start);
    fmt::print(
        "{:28} {:8} {:7.2f} {:7.2f} {:7.2f} {:7.2f} {:6.0f} {:5} {:7.0f} {:7.0f} {:7.0f} {:8} "
        "{:5.1f} {:7.2f} {:8.3f} {:7.3f}\n",
        name, structure.points.size(), plain_s, s, certificate_s, cpu, peak_mib(), plan.arcs.size(),
        p.base_m, p.filled_m, p.planned_m, held.surface_samples,
        100.0 * held.visible_samples / std::max<double>(1, held.surface_samples),
        100.0 * p.covered_by_base / std::max<double>(1, p.visible),
        100 * held.coverage_of_visible(), held.min_clearance_m());
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
      "{:28} {:>8} {:>7} {:>7} {:>7} {:>7} {:>6} {:>5} {:>7} {:>7} {:>7} {:>8} {:>5} {:>7} {:>8} "
      "{:>7}\n",
      "structure", "points", "base s", "plan s", "cert s", "CPU s", "MiB", "arcs", "base m",
      "fill m", "plan m", "samples", "vis %", "base %", "cert %", "clear m");
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
