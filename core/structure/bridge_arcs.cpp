// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/bridge_arcs.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/structure/base_arcs.hpp"
#include "core/structure/clearance.hpp"
#include "core/structure/cover.hpp"
#include "core/structure/cuts.hpp"
#include "core/structure/layers.hpp"
#include "core/structure/rows.hpp"
#include "core/structure/track.hpp"
#include "core/structure/validate.hpp"

namespace arcbid {

namespace {

constexpr double kMostViewpoints = 200'000;
constexpr double kLongest_m = 10'000;  // no bridge's tower-to-tower work is larger; wrong units are
constexpr double kTolerance_m = 0.05;  // by which outlines may be simplified

/// All tracks of one layer, before outlines are cut.
struct LayerTracks {
  std::vector<Track> top_rows, outlines, underside_rows;
};

class Planner {
 public:
  Planner(const Cover& surface, const CoverageSettings& settings, double floor_m)
      : settings_(settings),
        clearance_(surface.points, surface.clearance_m(settings.safety_m), floor_m),
        layers_(slice(surface.points, settings, floor_m)) {}

  /// Sections 2.1 to 2.3.
  void plan(ArcPlan& result) {
    require_few_viewpoints();
    std::vector<LayerTracks> tracks;
    for (std::size_t k = 0; k < layers_.size(); ++k)
      tracks.push_back({rows(k, Facing::up), outlines(k), rows(k, Facing::down)});
    for (std::size_t k = 0; k < layers_.size(); ++k) {
      const std::vector<Track> none;
      const auto& above = k > 0 ? tracks[k - 1].outlines : none;
      const auto& below = k + 1 < tracks.size() ? tracks[k + 1].outlines : none;
      append(tracks[k].top_rows, ArcKind::top_row, k, result.arcs);
      append(cut_open(tracks[k].outlines, above, below, settings_.spacing_m), ArcKind::outline, k,
             result.arcs);
      append(tracks[k].underside_rows, ArcKind::underside_row, k, result.arcs);
    }
    if (lost_m_ >= 0.1)
      result.warnings.push_back(
          fmt::format("{:.1f} m of path lines left out: no place there keeps {} m from the surface "
                      "and {} m above the ground",
                      lost_m_, settings_.safety_m, settings_.ground_clearance_m));
  }

 private:
  Repair repair() const {
    return {settings_.spacing_m, settings_.safety_m, settings_.spacing_m / 4};
  }

  std::vector<Track> kept(const Track& track, double least_m) {
    Repair how = repair();
    how.least_m = std::min(how.least_m, least_m);
    return kept_clear(track, clearance_, how, lost_m_);
  }

  std::vector<Track> outlines(std::size_t k) {
    std::vector<Track> result;
    for (const Ring& ring : offset_outlines(layers_[k].hulls, settings_.standoff_m)) {
      Track track{{}, true};
      for (const Vec2& p : ring) track.points.emplace_back(p.x(), p.y(), layers_[k].level_m);
      // A hole that small is a gap between rounded corners, not a place to fly.
      if (length_m(track) < settings_.standoff_m) continue;
      track = densified(simplified(track, kTolerance_m), settings_.spacing_m);
      for (Track& part : kept(track, repair().least_m)) result.push_back(std::move(part));
    }
    return result;
  }

  std::vector<Track> rows(std::size_t k, Facing facing) {
    const bool up = facing == Facing::up;
    const bool outermost = up ? k == 0 : k + 1 == layers_.size();
    const Layer* neighbour = outermost ? nullptr : &layers_[up ? k - 1 : k + 1];
    std::vector<Track> result;
    for (const Track& row :
         supplementary_rows(layers_[k], neighbour, facing, settings_, clearance_.floor_m()))
      // Rows over a small surface are short from the start.
      for (Track& part : kept(densified(row, settings_.spacing_m), length_m(row) / 2))
        result.push_back(std::move(part));
    return result;
  }

  /// Outlines look horizontally to the nearest hull; where that is beside the point, because the
  /// level was raised over the layer or the place is within a hull, to the nearest surface.
  Vec3 look(ArcKind kind, const Vec3& p, const Layer& layer) const {
    if (kind == ArcKind::top_row) return -Vec3::UnitZ();
    if (kind == ArcKind::underside_row) return Vec3::UnitZ();
    const Vec2 at = p.head<2>();
    const bool beside =
        p.z() <= layer.high_m && std::none_of(layer.hulls.begin(), layer.hulls.end(),
                                              [&](const Hull& h) { return contains(h.ring, at); });
    Vec2 nearest = layer.hulls.front().ring.front();
    for (const Hull& hull : layer.hulls) {
      const Vec2 on = nearest_on(hull.ring, at);
      if ((on - at).squaredNorm() < (nearest - at).squaredNorm()) nearest = on;
    }
    if (!beside || (nearest - at).norm() < 1e-6) return (clearance_.nearest(p) - p).normalized();
    const Vec2 toward = (nearest - at).normalized();
    return {toward.x(), toward.y(), 0};
  }

  void append(const std::vector<Track>& tracks, ArcKind kind, std::size_t k,
              std::vector<Arc>& arcs) const {
    for (const Track& track : tracks) {
      Arc arc{{static_cast<std::uint32_t>(arcs.size())}, kind, {}};
      for (const Vec3& p : track.points)
        if (arc.waypoints.empty() || arc.waypoints.back().position_m != p)
          arc.waypoints.push_back({p, look(kind, p, layers_[k])});
      if (arc.waypoints.size() >= 2) arcs.push_back(std::move(arc));
    }
  }

  void require_few_viewpoints() const {
    double sum = 0;
    for (const Layer& layer : layers_) sum += grid_cells(layer, settings_.spacing_m);
    if (sum > kMostViewpoints)
      throw InputError(fmt::format(
          "coverage.spacing_m: {} needs {:.0f} viewpoints for this structure; at least {:.3g} is "
          "legal "
          "(check the file's unit)",
          settings_.spacing_m, sum, settings_.spacing_m * std::sqrt(sum / kMostViewpoints)));
  }

  const CoverageSettings& settings_;
  Clearance clearance_;
  std::vector<Layer> layers_;  // top first
  double lost_m_ = 0;
};

/// Of samples that took no part in the planning.
double share_within_reach(const Structure& structure, const ArcPlan& plan,
                          const CoverageSettings& settings) {
  constexpr double kSamples = 20'000;
  std::vector<Vec3> waypoints;
  for (const Arc& arc : plan.arcs)
    for (const Waypoint& w : arc.waypoints) waypoints.push_back(w.position_m);
  const Clearance to_waypoints(waypoints, 0, 0);
  const double spacing_m = std::clamp(std::sqrt(plan.surface_m2 / kSamples), 1e-3, 1e4);
  const std::vector<Vec3> samples = surface_samples(structure, spacing_m, settings.seed);
  if (samples.empty()) return 0;
  const auto near = std::count_if(samples.begin(), samples.end(), [&](const Vec3& p) {
    return to_waypoints.distance_m(p) <= settings.standoff_m + settings.spacing_m;
  });
  return static_cast<double>(near) / static_cast<double>(samples.size());
}

void warn_of_size(const Vec3& size_m, ArcPlan& plan) {
  if (size_m.maxCoeff() > kLongest_m)
    plan.warnings.push_back(fmt::format(
        "the structure is {:.0f} m long: is the file in millimetres?", size_m.maxCoeff()));
}

}  // namespace

ArcPlan base_arcs(const Structure& structure, const CoverageSettings& settings) {
  validate(settings);
  const Bounds bounds = checked_bounds(structure);
  ArcPlan plan;
  plan.low_m = bounds.low_m;
  plan.high_m = bounds.high_m;
  if (plan.low_m == plan.high_m)
    throw InputError(
        "structure: all points are on one spot; at least two distinct ones are needed");
  warn_of_size(plan.high_m - plan.low_m, plan);

  const double sample_m =
      std::min({settings.spacing_m, settings.standoff_m, 2 * settings.safety_m}) / 16;
  const Cover surface = cover(structure, sample_m);
  plan.surface_m2 = surface.area_m2;
  if (surface.clearance_m(settings.safety_m) > settings.standoff_m)
    throw InputError(fmt::format(
        "structure: {:.3g} m2 are too many for coverage.standoff_m {} (check the file's unit)",
        plan.surface_m2, settings.standoff_m));

  const double ground_m = settings.ground_m.value_or(plan.low_m.z());
  Planner(surface, settings, ground_m + settings.ground_clearance_m).plan(plan);
  if (!plan.arcs.empty()) plan.within_reach = share_within_reach(structure, plan, settings);
  return plan;
}

void require_arcs(const ArcPlan& plan, const CoverageSettings& settings) {
  if (plan.arcs.empty())
    throw InputError(
        fmt::format("structure: no arc keeps coverage.safety_m {} from it and "
                    "coverage.ground_clearance_m {} above "
                    "the ground at z = {:.6g}",
                    settings.safety_m, settings.ground_clearance_m,
                    settings.ground_m.value_or(plan.low_m.z())));
}

ArcPlan bridge_arcs(const Structure& structure, const CoverageSettings& settings) {
  ArcPlan plan = base_arcs(structure, settings);
  require_arcs(plan, settings);
  return plan;
}

}  // namespace arcbid
