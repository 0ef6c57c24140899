// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace arcbid::certificate {
namespace {

constexpr double step_m = 0.25;        // between positions tried on one sight line
constexpr double far_ranges = 3;       // how far "out of range" is looked for
constexpr std::size_t flat_share = 4;  // one flat direction for so many steep ones

/// Evenly over the band of the unit sphere between two heights: a spiral of golden angles.
std::vector<Vec3> band(double low, double high, std::size_t count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Vec3> out;
  for (std::size_t n = 0; n < count; ++n) {
    const double z = high - (high - low) * (static_cast<double>(n) + 0.5) / count;
    const double across = std::sqrt(std::max(0.0, 1 - z * z)), angle = golden * n;
    out.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  return out;
}

/// Rays side by side cost less: each eight lie close together. The first eight are spread.
void group(std::vector<Vec3>& all) {
  const auto sector = [](const Vec3& d) {
    const double turn = (std::atan2(d.y(), d.x()) + std::numbers::pi) / (2 * std::numbers::pi);
    return std::min(15, static_cast<int>(16 * turn));
  };
  std::vector<Vec3> first, rest;
  for (std::size_t n = 0; n < all.size(); ++n)
    ((n % (all.size() / Rays::size) == 0 && first.size() < Rays::size) ? first : rest)
        .push_back(all[n]);
  std::stable_sort(rest.begin(), rest.end(),
                   [&](const Vec3& a, const Vec3& b) { return sector(a) < sector(b); });
  first.insert(first.end(), rest.begin(), rest.end());
  all = std::move(first);
}

std::size_t in_eights(std::size_t count) {
  return std::max<std::size_t>(1, (count + Rays::size - 1) / Rays::size) * Rays::size;
}

}  // namespace

Directions directions(double least_cosine, std::uint32_t steep) {
  Directions out{band(least_cosine, 1, in_eights(steep)),
                 band(0, least_cosine, in_eights(steep / flat_share))};
  group(out.steep);
  group(out.flat);
  return out;
}

struct Search::Found {
  bool visible = false, low = false, pocket = false, far = false, flat = false, no_look = false;

  bool any() const { return visible || low || pocket || far; }
  void add_flyable(bool can_point, bool is_steep, bool in_range) {
    if (is_steep && can_point) (in_range ? visible : far) = true;
    if (is_steep && !can_point && in_range) no_look = true;
    if (!is_steep && can_point && in_range) flat = true;
  }
  Finding first() const {
    if (visible) return Finding::visible;
    if (low) return Finding::too_low;
    if (pocket) return Finding::unreachable;
    if (far) return Finding::out_of_range;
    if (no_look) return Finding::no_look;
    return flat ? Finding::too_flat : Finding::occluded;
  }
};

/// Two axes across the normal, turned about it.
struct Search::Frame {
  Frame(const Vec3& normal, double turn) : z(normal) {
    const Vec3 other = std::abs(normal.z()) < 0.7 ? Vec3::UnitZ() : Vec3::UnitX();
    const Vec3 a = other.cross(normal).normalized(), b = normal.cross(a);
    const double angle = 2 * std::numbers::pi * turn;
    x = std::cos(angle) * a + std::sin(angle) * b;
    y = std::cos(angle) * b - std::sin(angle) * a;
  }
  Vec3 in_space(const Vec3& local) const { return local.x() * x + local.y() * y + local.z() * z; }
  Vec3 x, y, z;
};

Search::Search(const Sensing& sensing, const SightLines& lines, const FreeSpace& space,
               double safety_m, std::uint32_t count)
    : sensing_(sensing),
      lines_(lines),
      space_(space),
      safety_m_(safety_m),
      directions_(certificate::directions(sensing.least_cosine(), count)) {}

Finding Search::around(const Sample& sample, double turn) const {
  const Frame frame(sample.normal, turn);
  Found found;
  for (std::size_t n = 0; n < directions_.steep.size() && !found.visible; n += Rays::size)
    try_eight(sample, frame, &directions_.steep[n], true, found);
  if (found.any() || found.no_look) return found.first();
  for (std::size_t n = 0; n < directions_.flat.size() && !found.flat; n += Rays::size)
    try_eight(sample, frame, &directions_.flat[n], false, found);
  return found.first();
}

/// No position nearer than safety_m is free, so most rays of what nothing sees are short.
void Search::try_eight(const Sample& sample, const Frame& frame, const Vec3* local, bool is_steep,
                       Found& found) const {
  Rays rays;
  rays.asked = 0xff;
  for (std::size_t r = 0; r < Rays::size; ++r) {
    rays.directions[r] = frame.in_space(local[r]);
    rays.lengths_m[r] = safety_m_;
  }
  const std::uint8_t open = lines_.open(sample.eye_m, rays);
  for (std::size_t r = 0; r < Rays::size && !found.visible; ++r)
    if ((open >> r & 1) != 0) trace(sample, rays.directions[r], is_steep, found);
}

/// Along one sight line, until a flyable position is found. Exact distances are asked for only
/// where the answer could be better than what was found already.
void Search::trace(const Sample& sample, const Vec3& direction, bool is_steep, Found& found) const {
  const Sensor& sensor = sensing_.sensor();
  const bool can_point = sensing_.can_point(-direction), is_good = can_point && is_steep;
  const double most_m = (is_good && !found.any() ? far_ranges : 1) * sensor.range_m;
  const double reach_m = lines_.reach_m(sample.eye_m, direction, most_m);
  for (double t = safety_m_; t <= reach_m; t += step_m) {
    const Vec3 position = sample.eye_m + t * direction;
    const Place hope = space_.at_best(position);
    if (hope == Place::not_free || (hope != Place::flyable && !is_good)) continue;
    if ((hope == Place::pocket && found.pocket) || (hope == Place::too_low && found.low)) continue;
    const bool in_range = sensing_.in_range((position - sample.position_m).norm());
    if (hope != Place::flyable && !in_range) continue;
    const Place place = space_.place(position);
    if (place == Place::flyable) {
      found.add_flyable(can_point, is_steep, in_range);
      // What is too near may be in range farther out.
      if (in_range || t > sensor.least_range_m) return;
    }
    found.low = found.low || (is_good && in_range && place == Place::too_low);
    found.pocket = found.pocket || (is_good && in_range && place == Place::pocket);
  }
}

}  // namespace arcbid::certificate
