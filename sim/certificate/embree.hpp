// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include "core/structure/structure.hpp"

namespace arcbid::certificate {

/// A device and one scene of its own. Only .cpp files include this.
class EmbreeScene {
 public:
  EmbreeScene();
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene scene() const { return scene_; }
  /// Fills one geometry, makes it part of the scene and builds the scene.
  template <class Fill>
  void build(RTCGeometryType type, RTCSceneFlags flags, const Fill& fill) {
    const RTCGeometry geometry = rtcNewGeometry(device_, type);
    fill(geometry);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene_, flags);
    rtcCommitScene(scene_);
    require_no_error();
  }

 private:
  void require_no_error() const;

  RTCDevice device_;
  RTCScene scene_;
};

/// Floats are finest near zero, so scenes are built around the structure's middle.
Vec3 middle_of(const Structure& structure);
/// How far rounding to float may move anything that is within the structure's box, metres.
double float_error_m(const Structure& structure, const Vec3& middle);

/// The mesh as Embree wants it.
void fill_triangles(RTCGeometry geometry, const Structure& mesh, const Vec3& middle);

}  // namespace arcbid::certificate
