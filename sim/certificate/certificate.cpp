// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/certificate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/error.hpp"
#include "sim/certificate/parallel.hpp"
#include "sim/certificate/search.hpp"
#include "sim/certificate/seen.hpp"
#include "sim/certificate/surface.hpp"

namespace arcbid::certificate {
namespace {

void require_finite(const Structure& structure) {
  if (structure.points.empty()) throw InputError("the structure has no points: nothing to certify");
  for (const Vec3& point : structure.points)
    if (!point.allFinite())
      throw InputError("the structure has a point that is not finite: nothing can be certified");
}

void require_corners(const Structure& structure) {
  for (const auto& triangle : structure.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= structure.points.size())
        throw InputError("the structure has a triangle without one of its points");
}

double ground_of(const Structure& structure, const Settings& settings) {
  if (settings.ground_m) return *settings.ground_m;
  double lowest_m = structure.points.front().z();
  for (const Vec3& point : structure.points) lowest_m = std::min(lowest_m, point.z());
  return lowest_m;
}

/// The planner draws its samples from the mission's seed: these have to be others.
std::uint64_t own_seed(std::uint64_t mission_seed) {
  constexpr std::uint64_t of_certificates = 0x6365727469667921u;
  return mixed(of_certificates, mission_seed);
}

Fate fate_of(Finding finding) {
  switch (finding) {
    case Finding::visible:
      return Fate::missed;
    case Finding::too_low:
      return Fate::too_close_to_the_ground;
    case Finding::unreachable:
      return Fate::unreachable;
    case Finding::out_of_range:
      return Fate::out_of_range;
    case Finding::too_flat:
      return Fate::incidence;
    case Finding::no_look:
      return Fate::gimbal;
    case Finding::occluded:
      break;
  }
  return Fate::occluded;
}

/// All that is asked about one structure.
class Survey {
 public:
  Survey(const Structure& structure, const Settings& settings, const Progress& progress)
      : settings_(settings),
        progress_(progress),
        sensing_(settings.sensor),
        distances_(structure),
        surface_(surface_of(
            structure, {settings.spacing_m, own_seed(settings.mission_seed), settings.threads})),
        lines_(structure, surface_.balls),
        space_(structure, distances_,
               {settings.safety_m - tolerance_m,
                ground_of(structure, settings) + settings.ground_clearance_m,
                settings.sensor.range_m, settings.grid_m, settings.threads}),
        samples_(both_sides(surface_.points, lines_.least_offset_m())) {}

  Certificate run(const Flown& flown) {
    describe();
    say("clearance along every leg");
    out_.flown_m = certificate::flown_m(flown);
    out_.clearance = clearances(flown, distances_, space_.floor_m(), settings_.threads);
    say("what the routes see");
    std::vector<Path> legs;
    for (const Flight& flight : flown.flights)
      for (const FlownLeg& leg : flight.legs) legs.push_back(leg.waypoints);
    const std::vector<Seen> by_routes = seen_by(legs);
    say("what can be seen at all");
    const std::vector<Finding> findings = search(by_routes);
    const std::vector<Seen> by_arcs = seen_by(flown.arcs);
    for (std::size_t s = 0; s < samples_.size(); ++s)
      settle(s, by_routes[s], findings[s], by_arcs[s]);
    finish();
    return std::move(out_);
  }

 private:
  void say(std::string_view stage) const {
    if (progress_) progress_(stage);
  }

  void describe() {
    out_.settings = settings_;
    out_.seed = own_seed(settings_.mission_seed);
    out_.spacing_m = surface_.spacing_m;
    out_.surface_samples = samples_.size();
    out_.ground_samples = 2 * surface_.ground.size();
    out_.grid_m = space_.grid_m();
    out_.floor_m = space_.floor_m();
    out_.ray_offset_m = lines_.least_offset_m();
    for (const Sample& sample : samples_) out_.surface_m2 += sample.area_m2;
    out_.samples.resize(samples_.size());
  }

  std::vector<Seen> seen_by(const std::vector<Path>& paths) const {
    std::vector<Station> stations;
    for (const Path& path : paths) {
      const std::vector<Station> more = stations_on(path, settings_.step_m);
      stations.insert(stations.end(), more.begin(), more.end());
    }
    judge(stations, space_, settings_.threads);
    return seen_from(stations, samples_, sensing_, lines_, settings_.threads);
  }

  /// Of what no proper station sees; the others are visible, as their stations show.
  std::vector<Finding> search(const std::vector<Seen>& by_routes) {
    const Search search(sensing_, lines_, space_, settings_.safety_m - tolerance_m,
                        settings_.directions);
    out_.directions = search.directions();
    std::vector<Finding> findings(samples_.size(), Finding::visible);
    in_chunks(samples_.size(), 256, settings_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s)
        if (!by_routes[s].properly)
          findings[s] = search.around(samples_[s], share_of(mixed(out_.seed, s)));
    });
    return findings;
  }

  void settle(std::size_t s, const Seen& by_routes, Finding finding, const Seen& by_arcs) {
    const Sample& sample = samples_[s];
    SampleResult& result = out_.samples[s];
    result = {sample.position_m, sample.normal, fate_of(finding),
              finding == Finding::visible || by_arcs.properly, by_routes.times};
    if (by_arcs.times > 0 && result.visible) result.fate = Fate::not_assigned;
    if (by_routes.times > 0) result.fate = Fate::covered;
    ++out_.fates[static_cast<std::size_t>(result.fate)];
    out_.visible_samples += result.visible ? 1 : 0;
    if (result.fate != Fate::covered) return;
    ++out_.covered_samples;
    out_.covered_visible_samples += result.visible ? 1 : 0;
    out_.covered_m2 += sample.area_m2;
    Redundancy& r = out_.redundancy;
    r.least = out_.covered_samples == 1 ? result.times : std::min(r.least, result.times);
    r.mean += result.times;  // a sum until all are counted
    const auto bin = static_cast<std::size_t>(std::bit_width(result.times - 1));
    ++r.histogram[std::min(bin, r.histogram.size() - 1)];
  }

  void finish() {
    if (out_.covered_samples > 0) out_.redundancy.mean /= static_cast<double>(out_.covered_samples);
  }

  const Settings settings_;
  const Progress& progress_;
  const Sensing sensing_;
  const Distances distances_;
  const Surface surface_;
  const SightLines lines_;
  const FreeSpace space_;
  const std::vector<Sample> samples_;
  Certificate out_;
};

}  // namespace

double Certificate::min_clearance_m() const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const AgentClearance& agent : clearance)
    least_m = std::min(least_m, agent.flight.distance_m);
  return least_m;
}

double Certificate::home_clearance_m() const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const AgentClearance& agent : clearance) least_m = std::min(least_m, agent.home.distance_m);
  return least_m;
}

double Certificate::below_floor_m() const {
  double sum_m = 0;
  for (const AgentClearance& agent : clearance) sum_m += agent.below_floor_m;
  return sum_m;
}

bool Certificate::keeps_clear() const {
  return std::min(min_clearance_m(), home_clearance_m()) >= settings.safety_m - tolerance_m;
}

Certificate certify(const Structure& structure, const Flown& flown, const Settings& settings,
                    const Progress& progress) {
  require_corners(structure);
  const Structure used = structure.is_mesh() ? used_part(structure) : Structure{};
  const Structure& surface = structure.is_mesh() ? used : structure;
  require_finite(surface);
  return Survey(surface, settings, progress).run(flown);
}

}  // namespace arcbid::certificate
