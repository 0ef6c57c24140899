// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certificate/shapes.hpp"

namespace arcbid::certificate::testing {

void add_plate(Structure& mesh, const Vec3& at, const Vec3& a, const Vec3& b) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Vec3& corner : {Vec3(at), Vec3(at + a), Vec3(at + a + b), Vec3(at + b)})
    mesh.points.push_back(corner);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_box(Structure& mesh, const Vec3& low, const Vec3& high) {
  const Vec3 size = high - low;
  const Vec3 x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  add_plate(mesh, low, y, x);
  add_plate(mesh, low + z, x, y);
  add_plate(mesh, low, x, z);
  add_plate(mesh, low + y, z, x);
  add_plate(mesh, low, z, y);
  add_plate(mesh, low + x, y, z);
}

Structure level_plate(double half, double z) {
  Structure mesh;
  add_plate(mesh, {-half, -half, z}, {2 * half, 0, 0}, {0, 2 * half, 0});
  return mesh;
}

Flown flown(const std::vector<Vec3>& points, const Vec3& look) {
  Path path;
  for (const Vec3& point : points) path.push_back({point, look});
  return {.flights = {{1, {{0u, path}}}}, .arcs = {path}};
}

Settings settings() {
  Settings s;
  s.ground_m = 0;
  return s;
}

}  // namespace arcbid::certificate::testing
