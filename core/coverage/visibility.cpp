// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/coverage/parallel.hpp"

namespace arcbid {

namespace {

constexpr std::size_t kDirections = 256;
constexpr std::size_t kEscapes = 64;    // of them tried over the safety distance
constexpr int kLattice = 4, kFine = 1;  // cells between lattice positions
constexpr std::size_t kRemembered = 8;
constexpr float kNear_m = 0.5F;
constexpr int kTries = 4;  // places along one direction

}  // namespace

Visibility::Visibility(const Seer& seer, const Flyable& flyable, double safety_m)
    : seer_(seer), flyable_(flyable), safety_m_(safety_m) {
  const double least = seer.optics(Wanted::nominal).cos_incidence();
  double u = 0.5, v = 0.5;  // Roberts's R2 sequence
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double z = 1 - (1 - least) * u, r = std::sqrt(1 - z * z), a = 2 * std::numbers::pi * v;
    cone_.push_back(Vec3(r * std::cos(a), r * std::sin(a), z).cast<float>());
    u = std::fmod(u + 0.7548776662466927, 1.0);
    v = std::fmod(v + 0.5698402909980532, 1.0);
  }
}

Vec3f Visibility::direction(std::uint32_t sample, std::size_t k) const {
  const Vec3f& n = seer_.samples().normals[sample];
  const Vec3f side = std::abs(n.z()) < 0.9F ? Vec3f::UnitZ() : Vec3f::UnitX();
  const Vec3f x = n.cross(side).normalized(), y = n.cross(x);
  return cone_[k].x() * x + cone_[k].y() * y + cone_[k].z() * n;
}

bool Visibility::is_open(std::uint32_t sample) const {
  Vec3f from[8], to[8];
  const Vec3f& p = seer_.samples().points[sample];
  for (std::size_t k = 0; k < kEscapes; k += 8) {
    for (std::size_t i = 0; i < 8; ++i) {
      to[i] = p + static_cast<float>(safety_m_) * direction(sample, k + i);
      from[i] = seer_.start(sample);
    }
    if (seer_.scene().hidden(from, to, 8) != 0xFF) return true;
  }
  return false;
}

std::vector<bool> Visibility::open(const std::vector<bool>& asked, unsigned threads) const {
  std::vector<std::uint8_t> found(seer_.samples().size());
  for_chunks(found.size(), 1024, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t s = from; s < to; ++s)
      found[s] = asked[s] && is_open(static_cast<std::uint32_t>(s));
  });
  return {found.begin(), found.end()};
}

/// A bit for each of at most eight places.
unsigned Visibility::hidden_from(std::uint32_t sample, const std::vector<Vec3>& places) const {
  Vec3f from[8], to[8];
  for (std::size_t i = 0; i < places.size(); ++i) {
    to[i] = places[i].cast<float>();
    from[i] = seer_.start(sample);
  }
  return seer_.scene().hidden(from, to, static_cast<int>(places.size()));
}

/// Asks in packets; a place that the narrowed sensor can use ends the search.
void Visibility::try_places(std::uint32_t sample, const std::vector<Vec3>& places,
                            Witness& best) const {
  const Vec3f &p = seer_.samples().points[sample], &n = seer_.samples().normals[sample];
  Vec3f from[8], to[8];
  for (std::size_t k = 0; k < places.size() && best.how != Wanted::narrow; k += 8) {
    const std::size_t count = std::min<std::size_t>(8, places.size() - k);
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = places[k + i].cast<float>();
      from[i] = seer_.start(sample);
    }
    const unsigned hidden = seer_.scene().hidden(from, to, static_cast<int>(count));
    for (std::size_t i = 0; i < count && best.how != Wanted::narrow; ++i) {
      if (hidden >> i & 1) continue;
      for (const Wanted how : {Wanted::narrow, Wanted::nominal}) {
        const Optics& o = seer_.optics(how);
        const Vec3 way = p.cast<double>() - places[k + i];
        if (how == best.how || !o.in_reach(to[i], p, n) ||
            !o.in_view(pose_of(places[k + i], o.aim(way)), p))
          continue;
        best = {places[k + i], how};
        break;
      }
    }
  }
}

void Visibility::from_lattice(std::uint32_t sample, int step, Witness& best) const {
  const Vec3f &p = seer_.samples().points[sample], &n = seer_.samples().normals[sample];
  const Optics& o = seer_.optics(Wanted::nominal);
  const auto up = [step](int i) { return (i + step - 1) / step * step; };
  const Vec3 reach = Vec3::Constant(o.range_m());
  Flyable::Cell low = flyable_.cell_of(p.cast<double>() - reach);
  for (int& i : low) i = up(std::max(i, 0));
  const Flyable::Cell high = flyable_.cell_of(p.cast<double>() + reach);
  std::vector<Vec3> places;
  Flyable::Cell c;
  for (c[2] = low[2]; c[2] <= high[2]; c[2] += step)
    for (c[1] = low[1]; c[1] <= high[1]; c[1] += step)
      for (c[0] = low[0]; c[0] <= high[0]; c[0] += step)
        if (flyable_.reached(c) && o.in_reach(flyable_.centre(c).cast<float>(), p, n))
          places.push_back(flyable_.centre(c));
  try_places(sample, places, best);
}

/// The first place along a direction that lies in a flyable cell.
std::optional<double> Visibility::next_reached(const Vec3& from, const Vec3& direction,
                                               double from_m) const {
  const double range_m = seer_.optics(Wanted::narrow).range_m();
  for (double t = from_m; t < range_m; t += flyable_.cell_m())
    if (flyable_.reached(flyable_.cell_of(from + t * direction))) return t;
  return std::nullopt;
}

/// A line of sight is asked before an exact distance: it costs less and more often says no.
void Visibility::along_directions(std::uint32_t sample, std::size_t count, Witness& best) const {
  const Vec3 p = seer_.samples().points[sample].cast<double>();
  const double nearest_m = std::max<double>(safety_m_, seer_.optics(Wanted::narrow).least_m());
  for (std::size_t k = 0; k < count && best.how != Wanted::narrow; k += 8) {
    std::vector<Ray> rays;
    std::vector<Vec3> escapes;
    for (std::size_t i = k; i < k + 8; ++i)
      escapes.push_back(p + safety_m_ * direction(sample, i).cast<double>());
    const unsigned shut = hidden_from(sample, escapes);
    for (std::size_t i = 0; i < 8; ++i) {
      if (shut >> i & 1) continue;
      const Vec3 way = direction(sample, k + i).cast<double>();
      if (const auto t = next_reached(p, way, nearest_m)) rays.push_back({way, *t});
    }
    // Where the grid's cell is flyable but the place itself is not, the next one is asked.
    for (int tries = 0; tries < kTries && !rays.empty() && best.how != Wanted::narrow; ++tries) {
      std::vector<Vec3> places;
      for (const Ray& ray : rays) places.push_back(p + ray.at_m * ray.direction);
      std::vector<Ray> left;
      const unsigned hidden = hidden_from(sample, places);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hidden >> i & 1) continue;
        if (flyable_.reaches(places[i])) {
          try_places(sample, {places[i]}, best);
        } else if (const auto t =
                       next_reached(p, rays[i].direction, rays[i].at_m + flyable_.cell_m() / 2)) {
          left.push_back({rays[i].direction, *t});
        }
        if (best.how == Wanted::narrow) break;
      }
      rays = std::move(left);
    }
  }
}

/// All directions, or half of them where a near sample that faces the same way had no luck.
std::size_t Visibility::directions_for(std::uint32_t sample, const Seen& hopeless) const {
  const Samples& all = seer_.samples();
  const bool doubtful = std::any_of(hopeless.begin(), hopeless.end(), [&](std::uint32_t other) {
    return (all.points[other] - all.points[sample]).squaredNorm() < kNear_m * kNear_m &&
           all.normals[other].dot(all.normals[sample]) > 0.9F;
  });
  return doubtful ? kDirections / 2 : kDirections;
}

std::vector<Visibility::Witness> Visibility::witnesses(const Seen& samples,
                                                       unsigned threads) const {
  std::vector<Witness> found(samples.size());
  for_chunks(samples.size(), 256, threads, [&](std::size_t from, std::size_t to) {
    std::vector<Vec3> remembered;  // what served a sample often serves its neighbours
    Seen hopeless;
    for (std::size_t k = from; k < to; ++k) {
      try_places(samples[k], remembered, found[k]);
      if (found[k].how != Wanted::narrow) from_lattice(samples[k], kLattice, found[k]);
      if (found[k].how != Wanted::narrow)
        along_directions(samples[k], directions_for(samples[k], hopeless), found[k]);
      if (found[k].how == Wanted::no) {
        hopeless.push_back(samples[k]);
        continue;
      }
      if (remembered.size() == kRemembered) remembered.erase(remembered.begin());
      remembered.push_back(found[k].position_m);
    }
  });
  return found;
}

std::vector<Visibility::Witness> Visibility::rim_witnesses(const Seen& samples,
                                                           unsigned threads) const {
  std::vector<Witness> found(samples.size());
  for_chunks(samples.size(), 64, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) from_lattice(samples[k], kFine, found[k]);
  });
  return found;
}

}  // namespace arcbid
