// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/outlook.hpp"

#include <cmath>

namespace arcbid {

namespace {

constexpr float kCell_m = 0.6F;
constexpr std::uint32_t kEnough = 2;  // tries

/// A cell and one of six sides. Cells a million apart may share a key, which the structure's size
/// rules out.
std::uint64_t key_of(const Vec3f& p, const Vec3f& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  auto key = static_cast<std::uint64_t>(2 * axis + (normal[axis] > 0));
  for (int k = 0; k < 3; ++k)
    key = key << 20 |
          (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[k] / kCell_m))) &
           0xFFFFF);
  return key;
}

}  // namespace

void Outlook::learn(const Vec3f& point_m, const Vec3f& normal, bool visible) {
  Tried& tried = cells_[key_of(point_m, normal)];
  ++tried.samples;
  tried.visible += visible;
}

bool Outlook::hopeless(const Vec3f& point_m, const Vec3f& normal) const {
  const auto cell = cells_.find(key_of(point_m, normal));
  return cell != cells_.end() && cell->second.samples >= kEnough && cell->second.visible == 0;
}

bool Outlook::mixed(const Vec3f& point_m, const Vec3f& normal) const {
  const auto cell = cells_.find(key_of(point_m, normal));
  return cell != cells_.end() && cell->second.visible > 0;
}

}  // namespace arcbid
