// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/layers.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {

namespace {

constexpr double kMostLayers = 5000;
constexpr std::size_t kMostHulls = 2000;  // of one layer; later steps compare all with all

/// The planes: `count` slabs of `thickness_m` from `top_m` down, the lowest open to below.
struct Slabs {
  double top_m, thickness_m;
  std::size_t count;

  double middle_m(std::size_t k) const {
    return top_m - (static_cast<double>(k) + 0.5) * thickness_m;
  }
  std::size_t of(double z_m) const {
    const double k = thickness_m > 0 ? std::floor((top_m - z_m) / thickness_m) : 0;
    return std::min(static_cast<std::size_t>(std::max(k, 0.0)), count - 1);
  }
};

/// What lies more than half a spacing under the floor is seen, as far as it can be, from the lowest
/// level, at the floor: levels there would all be raised to that one.
Slabs slabs_of(double low_m, double high_m, double spacing_m, double floor_m) {
  const double bottom_m = std::min(std::max(low_m, floor_m - spacing_m / 2), high_m);
  const double count = std::max(1.0, std::ceil((high_m - bottom_m) / spacing_m));
  if (count > kMostLayers)
    throw InputError(fmt::format(
        "coverage.spacing_m: {} cuts a structure {:.6g} m tall into {:.0f} slices; at least {:.3g} "
        "is legal (check the file's unit)",
        spacing_m, high_m - low_m, count, (high_m - bottom_m) / kMostLayers));
  return {high_m, (high_m - bottom_m) / count, static_cast<std::size_t>(count)};
}

}  // namespace

std::vector<Layer> slice(const std::vector<Vec3>& points, const CoverageSettings& settings,
                         double floor_m) {
  double low_m = points.front().z(), high_m = low_m;
  for (const Vec3& p : points) {
    low_m = std::min(low_m, p.z());
    high_m = std::max(high_m, p.z());
  }
  const Slabs slabs = slabs_of(low_m, high_m, settings.spacing_m, floor_m);
  std::vector<Layer> layers(slabs.count);
  for (const Vec3& p : points) {
    Layer& layer = layers[slabs.of(p.z())];
    layer.high_m = layer.points.empty() ? p.z() : std::max(layer.high_m, p.z());
    layer.points.push_back(p);
  }

  // Nothing flies through a gap narrower than twice the safety distance.
  const double gap_m = 2 * settings.safety_m;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    Layer& layer = layers[k];
    layer.level_m = std::max(slabs.middle_m(k), floor_m);
    layer.hulls = clustered_hulls(layer.points, gap_m, gap_m / 16);
    if (layer.hulls.size() > kMostHulls)
      throw InputError(
          fmt::format("structure: falls into {} parts more than {} m apart at z = {:.6g} m; at "
                      "most {} are legal "
                      "(check the file's unit, or remove outliers)",
                      layer.hulls.size(), gap_m, layer.level_m, kMostHulls));
  }
  return layers;
}

}  // namespace arcbid
