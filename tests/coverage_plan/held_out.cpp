// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coverage_plan/held_out.hpp"

#include <algorithm>

#include "core/coverage/trim.hpp"
#include "core/coverage/visibility.hpp"

namespace arcbid {

HeldOut held_out(const Structure& structure, const std::vector<Arc>& arcs,
                 const CoverageSettings& settings) {
  constexpr unsigned threads = 2;
  const Surface surface = surface_of(structure, {}, threads);
  const Scene scene(surface);
  double ground_m = structure.points.front().z();
  for (const Vec3& p : structure.points) ground_m = std::min(ground_m, p.z());
  const double floor_m = settings.ground_m.value_or(ground_m) + settings.ground_clearance_m;
  const Flyable flyable(scene, surface,
                        {settings.safety_m, floor_m - surface.origin_m.z(),
                         settings.standoff_m + settings.safety_m + settings.sensor.range_m},
                        threads);
  const Samples samples = sided_samples(surface, 0.3, 987'654'321);
  const Seer seer(scene, surface, samples, settings.sensor);
  const Visibility visibility(seer, flyable, settings.safety_m);
  const std::vector<bool> open = visibility.open(std::vector<bool>(samples.size(), true), threads);
  std::vector<Wanted> wanted(samples.size(), Wanted::no);
  for (std::size_t s = 0; s < open.size(); ++s)
    if (open[s]) wanted[s] = Wanted::nominal;
  std::vector<bool> covered(samples.size());
  HeldOut result;
  result.samples = samples.size();
  result.least_clearance_m = 1e9;
  std::vector<Arc> local = arcs;
  for (Arc& arc : local) {
    for (Waypoint& w : arc.waypoints) w.position_m -= surface.origin_m;
    for (const Waypoint& w : stations(arc.waypoints, 0.1))
      result.least_clearance_m =
          std::min(result.least_clearance_m, scene.distance_m(w.position_m, 20));
  }
  for (const SeenArc& arc : look_along(seer, local, wanted, threads))
    for (const Seen& seen : arc.seen)
      for (const std::uint32_t s : seen) covered[s] = true;
  Seen rest;
  for (std::uint32_t s = 0; s < samples.size(); ++s)
    if (open[s] && !covered[s]) rest.push_back(s);
  result.covered = static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
  result.visible = result.covered;
  for (const auto& witness : visibility.witnesses(rest, threads))
    result.visible += witness.how != Wanted::no;
  return result;
}

}  // namespace arcbid
