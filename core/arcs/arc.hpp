// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/ids.hpp"

namespace arcbid {

/// Local East-North-Up frame, metres, z up.
using Vec3 = Eigen::Vector3d;

/// Where the drone is, and the unit vector toward the surface that it scans from there.
struct Waypoint {
  Vec3 position_m;
  Vec3 look;
};

/// What an arc was made from: a slice's outline, a row of supplementary viewpoints, or viewpoints
/// for what these leave unseen.
enum class ArcKind : std::uint8_t { outline, top_row, underside_row, gap };
std::string_view name(ArcKind kind);

/// The sensor that an arc needs, or that a UAV carries. `any` of an arc: it is all the same; of a
/// UAV: it carries whatever is needed.
enum class Payload : std::uint8_t { any, lidar, camera };
inline constexpr std::array<std::string_view, 3> payload_names{"any", "lidar", "camera"};
constexpr std::string_view name_of(Payload payload) {
  return payload_names[static_cast<std::size_t>(payload)];
}
constexpr bool serves(Payload carried, Payload needed) {
  return carried == needed || carried == Payload::any || needed == Payload::any;
}

/// L_arc,m of the paper (section 2.3): an open polyline that must be flown exactly once, in either
/// direction. At least two waypoints; consecutive ones are distinct; length > 0.
struct Arc {
  ArcId id;
  ArcKind kind = ArcKind::outline;
  std::vector<Waypoint> waypoints;
  Payload payload = Payload::any;  ///< what it must be flown with
};

/// Sum of the segments' lengths, in the order of the waypoints.
double length_m(const std::vector<Waypoint>& polyline);

/// The part of `polyline` between two distances from its first waypoint, 0 <= from_m < to_m <=
/// length. A cut inside a segment interpolates the position and (renormalised) the look direction;
/// a cut at 0 or at the length is bitwise the end waypoint, and equal distances give bitwise equal
/// points.
std::vector<Waypoint> part(const std::vector<Waypoint>& polyline, double from_m, double to_m);

/// The same polyline flown the other way.
std::vector<Waypoint> reversed(std::vector<Waypoint> polyline);

/// Digest over ids, kinds and all coordinates, bit for bit.
std::uint64_t digest(const std::vector<Arc>& arcs);

/// Points laid out for what is done to many of them at once. A point may carry the number that a
/// transit knows it by.
struct Points {
  static constexpr std::uint32_t unknown = UINT32_MAX;
  std::vector<double> x, y, z;
  std::vector<std::uint32_t> place;

  std::size_t size() const { return x.size(); }
  Vec3 at(std::size_t n) const { return {x[n], y[n], z[n]}; }
  void clear();
  void insert(std::size_t before, const Vec3& point, std::uint32_t place_number = unknown);
  void push_back(const Vec3& point, std::uint32_t place_number = unknown) {
    insert(size(), point, place_number);
  }
  /// Puts the last one in the place of number `n`.
  void remove(std::size_t n);
};

/// Travel between two points that belong to different arcs (eq. 2, second case), in metres. The
/// auction, the tour and the final route all ask the same object. Must be a metric on the points
/// asked for, except that asymmetric costs are allowed.
class Transit {
 public:
  virtual ~Transit() = default;
  virtual double length_m(const Vec3& from, const Vec3& to) const = 0;
  /// The number by which this transit knows a point; Points that carry it are looked up fast.
  virtual std::uint32_t place(const Vec3&) const { return Points::unknown; }
  /// The same for many at once, bit for bit: to each of `to`, and from each of `from`. `out` has
  /// room for all. Numbers that the points carry are this transit's.
  virtual void lengths_m(const Vec3& from, const Points& to, double* out) const;
  virtual void lengths_m(const Points& from, const Vec3& to, double* out) const;
  /// The way flown, both ends included.
  virtual std::vector<Vec3> way(const Vec3& from, const Vec3& to) const = 0;
};

/// Straight legs. Obstacle-aware transit takes its place behind the same interface.
class StraightTransit : public Transit {
 public:
  double length_m(const Vec3& from, const Vec3& to) const override { return (to - from).norm(); }
  void lengths_m(const Vec3& from, const Points& to, double* out) const override;
  void lengths_m(const Points& from, const Vec3& to, double* out) const override;
  std::vector<Vec3> way(const Vec3& from, const Vec3& to) const override { return {from, to}; }
};

}  // namespace arcbid
