// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// Counts what can be seen and what is, by asking everything of everything. For meshes of few
/// triangles; shares no code with the planner.
class BruteForce {
 public:
  BruteForce(const Structure& mesh, const CoverageSettings& settings);

  double distance_m(const Vec3& p) const;
  bool hidden(const Vec3& from, const Vec3& to) const;

  /// Of samples 0.4 m apart on both sides: those that the nominal sensor sees from some place of a
  /// half-metre grid that keeps its distance and can be reached over such places.
  struct Count {
    std::size_t samples = 0, visible = 0, covered = 0;
    double share() const { return static_cast<double>(covered) / static_cast<double>(visible); }
  };
  Count count(const std::vector<Arc>& arcs, std::uint32_t seed) const;

  double least_clearance_m(const std::vector<Arc>& arcs) const;

 private:
  struct Sample {
    Vec3 point, normal;
  };
  std::vector<Sample> samples(std::uint32_t seed) const;
  std::vector<Vec3> flyable_places() const;
  bool sees(const Waypoint& from, const Sample& sample, bool aimed) const;

  const Structure& mesh_;
  CoverageSettings settings_;
  double floor_m_;
};

}  // namespace arcbid
