// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/coverage/optics.hpp"
#include "core/coverage/scene.hpp"

namespace arcbid {

/// What is asked of a sample: nothing, that the narrowed sensor sees it, or that the nominal does.
enum class Wanted : std::uint8_t { no, narrow, nominal };

/// Numbers of samples, ascending.
using Seen = std::vector<std::uint32_t>;

/// Which samples are seen from where.
class Seer {
 public:
  /// Keeps references.
  Seer(const Scene& scene, const Surface& surface, const Samples& samples, const Sensor& sensor);

  /// Those of the wanted samples that are in range, on the right side, within incidence and not
  /// hidden: what a sensor that sees all round sees.
  Seen around(const Vec3& eye, const std::vector<Wanted>& wanted) const;
  /// Those of them that are in the image too.
  Seen in_view(const Waypoint& w, const Seen& around, const std::vector<Wanted>& wanted) const;
  Seen seen(const Waypoint& w, const std::vector<Wanted>& wanted) const;

  const Optics& optics(Wanted how) const { return how == Wanted::nominal ? nominal_ : narrow_; }
  const Scene& scene() const { return scene_; }
  const Surface& surface() const { return surface_; }
  const Samples& samples() const { return samples_; }

  /// Where its lines of sight start.
  Vec3f start(std::uint32_t sample) const {
    return samples_.points[sample] + samples_.lifts_m[sample] * samples_.normals[sample];
  }

 private:
  struct Box {
    Vec3f low, high;
    bool within(const Vec3f& eye, float range_m) const;
  };
  Seen in_reach(const Vec3f& eye, const Pose* pose, const std::vector<Wanted>& wanted) const;
  void drop_hidden(const Vec3f& eye, Seen& seen) const;

  const Scene& scene_;
  const Surface& surface_;
  const Samples& samples_;
  Optics nominal_, narrow_;
  std::vector<Box> runs_, bundles_;  // boxes around consecutive samples, and around those boxes
};

/// Places along arcs from which they are held to see: waypoints, and between them at most
/// `step_m` apart, with looks interpolated as whoever flies interpolates them.
std::vector<Waypoint> stations(const std::vector<Waypoint>& polyline, double step_m);

}  // namespace arcbid
