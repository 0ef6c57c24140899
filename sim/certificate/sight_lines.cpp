// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/sight_lines.hpp"

#include <algorithm>
#include <limits>

#include "sim/certificate/embree.hpp"

namespace arcbid::certificate {
namespace {

void fill_balls(RTCGeometry geometry, const std::vector<Ball>& balls, const Vec3& middle) {
  auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), balls.size()));
  for (std::size_t b = 0; b < balls.size(); ++b) {
    for (int axis = 0; axis < 3; ++axis)
      places[4 * b + axis] = static_cast<float>(balls[b].middle_m[axis] - middle[axis]);
    places[4 * b + 3] = static_cast<float>(balls[b].radius_m);
  }
}

}  // namespace

struct SightLines::Tree {
  Vec3 middle;
  double offset_m = 0;
  EmbreeScene embree;
};

SightLines::SightLines(const Structure& structure, const std::vector<Ball>& balls)
    : tree_(std::make_unique<Tree>()) {
  tree_->middle = middle_of(structure);
  constexpr double thinnest_m = 2e-3;  // of what stands apart: less than any plate is thick
  tree_->offset_m = std::max(thinnest_m, 2 * float_error_m(structure, tree_->middle));
  const Vec3& middle = tree_->middle;
  if (structure.is_mesh())
    tree_->embree.build(RTC_GEOMETRY_TYPE_TRIANGLE, RTC_SCENE_FLAG_ROBUST,
                        [&](RTCGeometry geometry) { fill_triangles(geometry, structure, middle); });
  else if (!balls.empty())
    tree_->embree.build(RTC_GEOMETRY_TYPE_SPHERE_POINT, RTC_SCENE_FLAG_ROBUST,
                        [&](RTCGeometry geometry) { fill_balls(geometry, balls, middle); });
}

SightLines::~SightLines() = default;

double SightLines::least_offset_m() const {
  return tree_->offset_m;
}

std::uint8_t SightLines::open(const Vec3& from, const Rays& rays) const {
  const Eigen::Vector3f at = (from - tree_->middle).cast<float>();
  alignas(32) std::array<int, Rays::size> valid;
  RTCRay8 packet;
  for (std::size_t r = 0; r < Rays::size; ++r) {
    valid[r] = (rays.asked >> r & 1) != 0 ? -1 : 0;
    packet.org_x[r] = at.x();
    packet.org_y[r] = at.y();
    packet.org_z[r] = at.z();
    packet.dir_x[r] = valid[r] ? static_cast<float>(rays.directions[r].x()) : 1;
    packet.dir_y[r] = valid[r] ? static_cast<float>(rays.directions[r].y()) : 0;
    packet.dir_z[r] = valid[r] ? static_cast<float>(rays.directions[r].z()) : 0;
    packet.tnear[r] = 0;
    packet.tfar[r] = valid[r] ? static_cast<float>(rays.lengths_m[r]) : 0;
    packet.time[r] = 0;
    packet.mask[r] = ~0u;
    packet.id[r] = static_cast<unsigned>(r);
    packet.flags[r] = 0;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid.data(), tree_->embree.scene(), &context, &packet);
  std::uint8_t open = 0;
  for (std::size_t r = 0; r < Rays::size; ++r)
    if (valid[r] && packet.tfar[r] >= 0) open |= static_cast<std::uint8_t>(1u << r);
  return open;
}

double SightLines::reach_m(const Vec3& from, const Vec3& direction, double most_m) const {
  const Eigen::Vector3f at = (from - tree_->middle).cast<float>(), to = direction.cast<float>();
  RTCRayHit ray{};
  ray.ray = {at.x(), at.y(), at.z(), 0, to.x(), to.y(), to.z(), 0, static_cast<float>(most_m),
             ~0u,    0,      0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(tree_->embree.scene(), &context, &ray);
  return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? most_m : static_cast<double>(ray.ray.tfar);
}

}  // namespace arcbid::certificate
