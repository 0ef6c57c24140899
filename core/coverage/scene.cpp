// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {

namespace {

/// Squared distance from a triangle, wires and spots among them: to its inside where p is over it,
/// else to its nearest edge.
double squared_m2(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto edge = [&p](const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double length2 = way.squaredNorm();
    const double share = length2 > 0 ? std::clamp((p - from).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (p - from - share * way).squaredNorm();
  };
  const Vec3 normal = (b - a).cross(c - a);
  const double area2 = normal.squaredNorm();
  if (area2 > 0 && (b - a).cross(p - a).dot(normal) >= 0 && (c - b).cross(p - b).dot(normal) >= 0 &&
      (a - c).cross(p - c).dot(normal) >= 0) {
    const double off = (p - a).dot(normal);
    return off * off / area2;
  }
  return std::min({edge(a, b), edge(b, c), edge(c, a)});
}

struct Nearest {
  const Surface& surface;
  Vec3 p;
  double squared_m2;
};

bool visit(RTCPointQueryFunctionArguments* args) {
  auto& nearest = *static_cast<Nearest*>(args->userPtr);
  const Surface& s = nearest.surface;
  double d2;
  if (s.is_mesh()) {
    const auto& t = s.triangles[args->primID];
    d2 = squared_m2(nearest.p, s.points[t[0]], s.points[t[1]], s.points[t[2]]);
  } else {
    d2 = (s.points[args->primID] - nearest.p).squaredNorm();
  }
  if (d2 >= nearest.squared_m2) return false;
  nearest.squared_m2 = d2;
  // The tree's boxes are floats: a hair more than the distance, so that none is passed over.
  args->query->radius = static_cast<float>(std::sqrt(d2) * 1.00001 + 1e-3);
  return true;
}

void fill(float* to, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<float>(p[axis]);
}

RTCGeometry triangles(RTCDevice device, const Surface& s) {
  RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), s.points.size()));
  for (std::size_t i = 0; i < s.points.size(); ++i) fill(v + 3 * i, s.points[i]);
  auto* t = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), s.triangles.size()));
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    std::copy(s.triangles[i].begin(), s.triangles[i].end(), t + 3 * i);
  return g;
}

RTCGeometry spheres(RTCDevice device, const Surface& s) {
  RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(
      g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), s.surfels.size()));
  for (std::size_t i = 0; i < s.surfels.size(); ++i) {
    Eigen::Map<Vec3f>(v + 4 * i) = s.surfels[i].point_m;
    v[4 * i + 3] = s.surfels[i].radius_m;
  }
  return g;
}

void bounds_of_dot(const RTCBoundsFunctionArguments* args) {
  const Vec3& p = static_cast<const Surface*>(args->geometryUserPtr)->points[args->primID];
  constexpr float slack_m = 1e-3F;  // more than a float's error within ten kilometres
  const Vec3f f = p.cast<float>();
  RTCBounds& b = *args->bounds_o;
  b.lower_x = f.x() - slack_m;
  b.lower_y = f.y() - slack_m;
  b.lower_z = f.z() - slack_m;
  b.upper_x = f.x() + slack_m;
  b.upper_y = f.y() + slack_m;
  b.upper_z = f.z() + slack_m;
}

/// Embree 3 asks no point geometry for distances, but it does ask what users define.
RTCGeometry dots(RTCDevice device, const Surface& s) {
  RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(s.points.size()));
  rtcSetGeometryUserData(g, const_cast<Surface*>(&s));
  rtcSetGeometryBoundsFunction(g, bounds_of_dot, nullptr);
  return g;
}

RTCScene scene_of(RTCDevice device, RTCGeometry geometry, RTCSceneFlags flags) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, flags);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

RTCIntersectContext context(RTCIntersectContextFlags flags) {
  RTCIntersectContext c;
  rtcInitIntersectContext(&c);
  c.flags = flags;
  return c;
}

}  // namespace

struct Scene::Index {
  RTCDevice device;
  RTCScene sight;  // what hides
  RTCScene near;   // what distances are taken from: the same for a mesh

  explicit Index(const Surface& s) : device(rtcNewDevice(nullptr)) {
    check(device != nullptr, "Embree starts");
    if (s.is_mesh()) {
      sight = near = scene_of(device, triangles(device, s), RTC_SCENE_FLAG_ROBUST);
      rtcRetainScene(near);
    } else {
      sight = scene_of(device, spheres(device, s), RTC_SCENE_FLAG_NONE);
      near = scene_of(device, dots(device, s), RTC_SCENE_FLAG_NONE);
    }
  }
  ~Index() {
    rtcReleaseScene(near);
    rtcReleaseScene(sight);
    rtcReleaseDevice(device);
  }
};

Scene::Scene(const Surface& surface)
    : surface_(surface), index_(std::make_unique<Index>(surface)) {}
Scene::~Scene() = default;

double Scene::distance_m(const Vec3& p, double most_m) const {
  Nearest nearest{surface_, p, most_m * most_m};
  RTCPointQuery query{};
  query.x = static_cast<float>(p.x());
  query.y = static_cast<float>(p.y());
  query.z = static_cast<float>(p.z());
  query.radius = static_cast<float>(most_m * 1.00001 + 1e-3);
  RTCPointQueryContext c;
  rtcInitPointQueryContext(&c);
  rtcPointQuery(index_->near, &query, &c, visit, &nearest);
  return std::sqrt(nearest.squared_m2);
}

unsigned Scene::hidden(const Vec3f* from, const Vec3f* to, int count) const {
  alignas(32) int valid[8];
  alignas(32) RTCRay8 ray;
  for (int i = 0; i < 8; ++i) {
    valid[i] = i < count ? -1 : 0;
    const Vec3f& start = from[i < count ? i : 0];
    const Vec3f way = i < count ? Vec3f(to[i] - start) : Vec3f(Vec3f::UnitX());
    ray.org_x[i] = start.x();
    ray.org_y[i] = start.y();
    ray.org_z[i] = start.z();
    ray.dir_x[i] = way.x();
    ray.dir_y[i] = way.y();
    ray.dir_z[i] = way.z();
    ray.tnear[i] = 0;
    ray.tfar[i] = 1;
    ray.time[i] = 0;
    ray.mask[i] = ~0u;
    ray.id[i] = ray.flags[i] = 0;
  }
  RTCIntersectContext c = context(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  rtcOccluded8(valid, index_->sight, &c, &ray);
  unsigned bits = 0;
  for (int i = 0; i < count; ++i)
    if (ray.tfar[i] < 0) bits |= 1u << i;
  return bits;
}

float Scene::free_m(const Vec3f& from, const Vec3f& direction, float most_m) const {
  RTCRayHit hit{};
  hit.ray.org_x = from.x();
  hit.ray.org_y = from.y();
  hit.ray.org_z = from.z();
  hit.ray.dir_x = direction.x();
  hit.ray.dir_y = direction.y();
  hit.ray.dir_z = direction.z();
  hit.ray.tfar = most_m;
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext c = context(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  rtcIntersect1(index_->sight, &c, &hit);
  return hit.ray.tfar;
}

}  // namespace arcbid
