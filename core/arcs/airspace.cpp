// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/airspace.hpp"

#include "core/base/digest.hpp"

namespace arcbid {
namespace {

void add(Digest& d, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) d.add(p[axis]);
}

}  // namespace

std::uint64_t digest(const Airspace& airspace) {
  Digest d;
  add(d, airspace.low_m);
  d.add(airspace.cell_m);
  for (const std::uint32_t cells : airspace.cells) d.add(std::uint64_t{cells});
  for (const std::uint8_t byte : airspace.runs) d.add(std::uint64_t{byte});
  d.add(std::uint64_t{airspace.runs.size()});
  for (const Access& access : airspace.accesses) {
    d.add(std::uint64_t{access.arc.value}).add(std::uint64_t{access.waypoint});
    for (const AccessPoint& p : access.points) add(d, p.position_m);
    d.add(std::uint64_t{access.points.size()});
  }
  return d.add(std::uint64_t{airspace.accesses.size()}).value();
}

}  // namespace arcbid
