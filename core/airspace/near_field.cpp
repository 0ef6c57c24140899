// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr std::uint16_t kFar = 30'000;
constexpr int kMostReach = 120;  // cells: its square stays under kFar

}  // namespace

NearField::NearField(const std::vector<Vec3>& points, const Airspace& airspace, double reach_m)
    : cell_m_(airspace.cell_m) {
  reach_ = static_cast<int>(std::ceil(reach_m / cell_m_)) + 2;
  check(reach_ <= kMostReach, "cells are not that small against the safety distance");
  under_ = static_cast<std::size_t>(reach_);
  size_ = {airspace.cells[0], airspace.cells[1], airspace.cells[2] + under_};
  squared_.assign(size_[0] * size_[1] * size_[2], kFar);
  const Vec3 low_m = airspace.low_m - Vec3(0, 0, cell_m_ * reach_);
  for (const Vec3& p : points) {
    const Vec3 at = ((p - low_m) / cell_m_).array().floor();
    bool holds = true;
    std::array<std::size_t, 3> c{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      holds = holds && at[axis] >= 0 && at[axis] < static_cast<double>(size_[k]);
      if (holds) c[k] = static_cast<std::size_t>(at[axis]);
    }
    if (holds) squared_[c[0] + size_[0] * (c[1] + size_[1] * c[2])] = 0;
  }
  for (const std::size_t axis : {0, 1, 2}) spread(axis);
}

/// Along one axis, every cell takes the least of what its neighbours have plus their squared
/// distance. Whole rows at once, but for the first axis.
void NearField::spread(std::size_t axis) {
  const std::size_t stride = axis == 0 ? 1 : axis == 1 ? size_[0] : size_[0] * size_[1];
  const std::size_t count = size_[axis], block = stride * count;
  std::vector<std::uint16_t> before(block);
  for (std::size_t begin = 0; begin < squared_.size(); begin += block) {
    std::uint16_t* const out = squared_.data() + begin;
    std::copy_n(out, block, before.begin());
    if (std::all_of(before.begin(), before.end(), [](std::uint16_t d) { return d == kFar; }))
      continue;
    for (int d = 1; d <= reach_; ++d) {
      const auto squared = static_cast<std::uint16_t>(d * d);
      const std::size_t shift = static_cast<std::size_t>(d) * stride;
      if (shift >= block) break;
      const std::uint16_t* const in = before.data();
      for (std::size_t n = shift; n < block; ++n) {
        const auto lower = static_cast<std::uint16_t>(in[n - shift] + squared);
        out[n] = std::min(out[n], lower);
      }
      for (std::size_t n = 0; n + shift < block; ++n) {
        const auto upper = static_cast<std::uint16_t>(in[n + shift] + squared);
        out[n] = std::min(out[n], upper);
      }
    }
    for (std::size_t n = 0; n < block; ++n) out[n] = std::min(out[n], kFar);
  }
}

NearField::Bounds NearField::bounds(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
  const std::uint16_t squared = squared_[x + size_[0] * (y + size_[1] * (z + under_))];
  const double distance_m = std::sqrt(static_cast<double>(squared)) * cell_m_;
  // A point is up to half a diagonal away from the centre of its cell.
  const double error_m = std::sqrt(3.0) / 2 * cell_m_ + 1e-9;
  if (squared > reach_ * reach_)
    return {(reach_ - 1) * cell_m_, std::numeric_limits<double>::infinity()};
  return {distance_m - error_m, distance_m + error_m};
}

}  // namespace arcbid
