// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/structure/sensor.hpp"
#include "core/structure/structure.hpp"
#include "sim/certificate/flight.hpp"
#include "sim/certificate/route_clearance.hpp"

namespace arcbid::certificate {

struct Settings {
  Sensor sensor;
  double safety_m = 2;
  double ground_clearance_m = 3;
  std::optional<double> ground_m;  ///< none: the structure's lowest point
  double spacing_m = 0.3;          ///< one surface point for each spacing_m^2
  std::uint64_t mission_seed = 1;  ///< the samples' own seed is made from it
  std::uint32_t directions = 256;  ///< along which a position is looked for, for every sample
  double grid_m = 0.5;             ///< of the grid that tells what is connected
  double step_m = 0.25;            ///< between places on a route
  unsigned threads = 0;            ///< 0: as many as there are processors; never seen in results
};

/// What became of a sample: covered, or why not; the first that holds (docs/COVERAGE.md).
enum class Fate : std::uint8_t {
  covered,
  missed,                   ///< visible, and no arc sees it
  not_assigned,             ///< visible, an arc sees it, and no route does
  too_close_to_the_ground,  ///< a position would see it, were there neither floor nor ground
  unreachable,              ///< seen only from positions that are not connected to the outside
  out_of_range,             ///< seen only from too far or too near
  gimbal,                   ///< seen only at elevations that the gimbal cannot take
  incidence,                ///< seen only at too flat an angle
  occluded                  ///< no free position sees it in any direction
};
inline constexpr std::array<std::string_view, 9> fate_names{
    "covered",     "missed",       "not assigned", "too close to the ground",
    "unreachable", "out of range", "gimbal",       "incidence",
    "occluded"};

/// One side of a surface point, as certificate_samples.bin has it.
struct SampleResult {
  Vec3 position_m, normal;
  Fate fate = Fate::occluded;
  bool visible = false;
  std::uint32_t times = 0;  ///< stretches of 1 m of the routes that see it
};

/// Of the samples that are covered: how many stretches of 1 m of the routes see each.
struct Redundancy {
  double mean = 0;
  std::uint32_t least = 0;
  /// Samples seen from 1, 2, 3 to 4, 5 to 8, 9 to 16, 17 to 32 stretches, and from more.
  std::array<std::uint64_t, 7> histogram{};
};

struct Certificate {
  // The surface; a sample is one side of a surface point.
  std::uint64_t surface_samples = 0, ground_samples = 0;
  std::uint64_t visible_samples = 0, covered_samples = 0, covered_visible_samples = 0;
  double surface_m2 = 0;  ///< of both sides
  double covered_m2 = 0;
  double spacing_m = 0;
  std::array<std::uint64_t, fate_names.size()> fates{};
  Redundancy redundancy;
  // The routes.
  double flown_m = 0;
  std::vector<AgentClearance> clearance;
  // How it was measured.
  std::uint64_t seed = 0;
  std::size_t directions = 0;
  double grid_m = 0, floor_m = 0, ray_offset_m = 0;
  Settings settings;
  std::vector<SampleResult> samples;

  double coverage_of_visible() const { return share(covered_visible_samples, visible_samples); }
  double coverage_of_total() const { return share(covered_samples, surface_samples); }
  double metres_per_m2() const { return covered_m2 > 0 ? flown_m / covered_m2 : 0; }
  double min_clearance_m() const;   ///< infinite: nothing was flown
  double home_clearance_m() const;  ///< of the ways up from home and down again, below the floor
  double below_floor_m() const;
  /// Nothing flown is nearer than safety_m, up to a millimetre.
  bool keeps_clear() const;

 private:
  static double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Clearances that are less by no more are forgiven: rounding, and distances said in millimetres.
inline constexpr double tolerance_m = 1e-3;

/// A word at the beginning of each stage, for people.
using Progress = std::function<void(std::string_view)>;

/// Certifies what was flown around a structure (docs/COVERAGE.md). The same input gives the same
/// certificate, bit for bit, whatever the number of threads. Throws InputError for a structure
/// without points or with coordinates that are not finite.
Certificate certify(const Structure& structure, const Flown& flown, const Settings& settings,
                    const Progress& progress = {});

}  // namespace arcbid::certificate
