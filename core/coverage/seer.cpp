// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/seer.hpp"

#include <algorithm>
#include <cmath>

namespace arcbid {

namespace {

constexpr std::size_t kRun = 64;                        // samples that share a box
constexpr std::size_t kBundle = 16;                     // boxes that share a box
constexpr double kMeshOff_deg = 3, kCloudOff_deg = 12;  // a cloud's normals are estimates

}  // namespace

bool Seer::Box::within(const Vec3f& eye, float range_m) const {
  return (eye - eye.cwiseMax(low).cwiseMin(high)).squaredNorm() <= range_m * range_m;
}

Seer::Seer(const Scene& scene, const Surface& surface, const Samples& samples, const Sensor& sensor)
    : scene_(scene),
      surface_(surface),
      samples_(samples),
      nominal_(sensor),
      narrow_(narrowed(sensor, surface.is_mesh() ? kMeshOff_deg : kCloudOff_deg)) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3f& p = samples.points[i];
    if (i % kRun == 0) runs_.push_back({p, p});
    runs_.back() = {runs_.back().low.cwiseMin(p), runs_.back().high.cwiseMax(p)};
  }
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    if (r % kBundle == 0) bundles_.push_back(runs_[r]);
    bundles_.back() = {bundles_.back().low.cwiseMin(runs_[r].low),
                       bundles_.back().high.cwiseMax(runs_[r].high)};
  }
}

Seen Seer::in_reach(const Vec3f& eye, const Pose* pose, const std::vector<Wanted>& wanted) const {
  Seen found;
  for (std::size_t b = 0; b < bundles_.size(); ++b) {
    if (!bundles_[b].within(eye, nominal_.range_m())) continue;
    for (std::size_t r = b * kBundle; r < std::min((b + 1) * kBundle, runs_.size()); ++r) {
      if (!runs_[r].within(eye, nominal_.range_m())) continue;
      for (std::size_t s = r * kRun; s < std::min((r + 1) * kRun, samples_.size()); ++s) {
        if (wanted[s] == Wanted::no) continue;
        const Optics& o = optics(wanted[s]);
        if (o.in_reach(eye, samples_.points[s], samples_.normals[s]) &&
            (!pose || o.in_view(*pose, samples_.points[s])))
          found.push_back(static_cast<std::uint32_t>(s));
      }
    }
  }
  return found;
}

void Seer::drop_hidden(const Vec3f& eye, Seen& seen) const {
  Vec3f from[8], to[8];
  std::size_t kept = 0;
  for (std::size_t k = 0; k < seen.size(); k += 8) {
    const int count = static_cast<int>(std::min<std::size_t>(8, seen.size() - k));
    for (int i = 0; i < count; ++i) {
      from[i] = eye;
      to[i] = start(seen[k + static_cast<std::size_t>(i)]);
    }
    const unsigned hidden = scene_.hidden(from, to, count);
    for (int i = 0; i < count; ++i)
      if (!(hidden >> i & 1)) seen[kept++] = seen[k + static_cast<std::size_t>(i)];
  }
  seen.resize(kept);
}

Seen Seer::around(const Vec3& eye, const std::vector<Wanted>& wanted) const {
  Seen seen = in_reach(eye.cast<float>(), nullptr, wanted);
  drop_hidden(eye.cast<float>(), seen);
  return seen;
}

Seen Seer::in_view(const Waypoint& w, const Seen& around, const std::vector<Wanted>& wanted) const {
  const Pose pose = pose_of(w.position_m, w.look);
  Seen seen;
  std::copy_if(around.begin(), around.end(), std::back_inserter(seen), [&](std::uint32_t s) {
    return optics(wanted[s]).in_view(pose, samples_.points[s]);
  });
  return seen;
}

Seen Seer::seen(const Waypoint& w, const std::vector<Wanted>& wanted) const {
  const Pose pose = pose_of(w.position_m, w.look);
  Seen seen = in_reach(pose.position_m, &pose, wanted);
  drop_hidden(pose.position_m, seen);
  return seen;
}

std::vector<Waypoint> stations(const std::vector<Waypoint>& polyline, double step_m) {
  std::vector<Waypoint> places;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const Waypoint &a = polyline[i], &b = polyline[i + 1];
    const double n = std::max(1.0, std::ceil((b.position_m - a.position_m).norm() / step_m - 1e-9));
    places.push_back(a);
    for (double k = 1; k < n; ++k) {
      const double share = k / n;
      const Vec3 look = a.look + share * (b.look - a.look);
      places.push_back({a.position_m + share * (b.position_m - a.position_m),
                        look.norm() > 1e-9 ? Vec3(look.normalized()) : (share < 0.5 ? a : b).look});
    }
  }
  if (!polyline.empty()) places.push_back(polyline.back());
  return places;
}

}  // namespace arcbid
