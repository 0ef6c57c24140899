// SPDX-License-Identifier: GPL-3.0-or-later
// How long a certificate takes: of one drone that flies every arc of a structure.
//
//   certificate_bench [STRUCTURE [UNIT [SPACING_M [THREADS]]]]    (the built-in bridge)
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <string>

#include "core/io/structure_reader.hpp"
#include "core/structure/bridge_arcs.hpp"
#include "core/structure/parametric.hpp"
#include "sim/certificate/files.hpp"

namespace {

using namespace arcbid;
using Clock = std::chrono::steady_clock;

double cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

certificate::Flown every_arc(const ArcPlan& plan) {
  certificate::Flown flown;
  certificate::Flight flight{1, {}};
  for (const Arc& arc : plan.arcs) {
    flown.arcs.push_back(arc.waypoints);
    flight.legs.push_back({arc.id.value, arc.waypoints});
  }
  flown.flights.push_back(flight);
  return flown;
}

}  // namespace

int main(int argc, char** argv) {
  Structure structure = argc > 1
                            ? read_structure(argv[1], {.unit = argc > 2 ? argv[2] : "m"}).structure
                            : generate(ParametricBridge{.length_m = 200});
  auto start = Clock::now();
  const ArcPlan plan = bridge_arcs(structure, {});
  fmt::print("{} points, {} triangles, {} arcs in {:.2f} s\n", structure.points.size(),
             structure.triangles.size(), plan.arcs.size(), since_s(start));
  certificate::Settings settings;
  if (argc > 3) settings.spacing_m = std::stod(argv[3]);
  if (argc > 4) settings.threads = static_cast<unsigned>(std::stoul(argv[4]));
  start = Clock::now();
  const double before_s = cpu_s();
  const certificate::Certificate result =
      certificate::certify(structure, every_arc(plan), settings, [&](std::string_view stage) {
        fmt::print("{:7.2f} s, {:.2f} s of CPU  {}\n", since_s(start), cpu_s() - before_s, stage);
      });
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("{:7.2f} s, {:.2f} s of CPU  done, {} MB\n{}", since_s(start), cpu_s() - before_s,
             usage.ru_maxrss / 1024, certificate::table(result));
}
