// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/arcs/arc.hpp"

namespace arcbid {

void Points::clear() {
  for (auto* axis : {&x, &y, &z}) axis->clear();
  place.clear();
}

void Points::insert(std::size_t before, const Vec3& point, std::uint32_t place_number) {
  const auto at = static_cast<std::ptrdiff_t>(before);
  x.insert(x.begin() + at, point.x());
  y.insert(y.begin() + at, point.y());
  z.insert(z.begin() + at, point.z());
  place.insert(place.begin() + at, place_number);
}

void Points::remove(std::size_t n) {
  for (auto* axis : {&x, &y, &z}) {
    (*axis)[n] = axis->back();
    axis->pop_back();
  }
  place[n] = place.back();
  place.pop_back();
}

void Transit::lengths_m(const Vec3& from, const Points& to, double* out) const {
  for (std::size_t n = 0; n < to.size(); ++n) out[n] = length_m(from, to.at(n));
}

void Transit::lengths_m(const Points& from, const Vec3& to, double* out) const {
  for (std::size_t n = 0; n < from.size(); ++n) out[n] = length_m(from.at(n), to);
}

/// Straight legs are as long there as back, to the last bit. The sum is in Eigen's order, so that
/// one length and many come out alike.
void StraightTransit::lengths_m(const Vec3& from, const Points& to, double* out) const {
  const double x0 = from.x(), y0 = from.y(), z0 = from.z();
  const double *x = to.x.data(), *y = to.y.data(), *z = to.z.data();
  const std::size_t size = to.size();
  for (std::size_t n = 0; n < size; ++n) {
    const double dx = x[n] - x0, dy = y[n] - y0, dz = z[n] - z0;
    out[n] = std::sqrt(dx * dx + (dy * dy + dz * dz));
  }
}

void StraightTransit::lengths_m(const Points& from, const Vec3& to, double* out) const {
  lengths_m(to, from, out);
}

}  // namespace arcbid
