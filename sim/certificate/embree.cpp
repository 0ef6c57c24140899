// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/embree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.hpp"

namespace arcbid::certificate {

EmbreeScene::EmbreeScene() : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
  rtcCommitScene(scene_);  // an empty one may be asked too
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreeScene::require_no_error() const {
  if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE)
    throw RunError(fmt::format("Embree could not build its scene: error {}{}",
                               static_cast<int>(error),
                               error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory" : ""));
}

Vec3 middle_of(const Structure& structure) {
  if (structure.points.empty()) return Vec3::Zero();
  Vec3 low = structure.points.front(), high = low;
  for (const Vec3& point : structure.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return 0.5 * (low + high);
}

double float_error_m(const Structure& structure, const Vec3& middle) {
  double farthest_m = 0;
  for (const Vec3& point : structure.points)
    farthest_m = std::max(farthest_m, (point - middle).cwiseAbs().maxCoeff());
  constexpr double relative = 1.0 / (1 << 22);  // four times the rounding of one float
  return farthest_m * relative;
}

void fill_triangles(RTCGeometry geometry, const Structure& mesh, const Vec3& middle) {
  auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                              RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                              mesh.points.size()));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    for (int axis = 0; axis < 3; ++axis)
      corners[3 * p + axis] = static_cast<float>(mesh.points[p][axis] - middle[axis]);
  auto* numbers = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    std::copy(mesh.triangles[t].begin(), mesh.triangles[t].end(), numbers + 3 * t);
}

}  // namespace arcbid::certificate
