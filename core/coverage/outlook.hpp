// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>

#include "core/coverage/surface.hpp"

namespace arcbid {

/// Where on the surface samples could be seen: of later samples, those near many that could not be
/// seen are worth less work.
class Outlook {
 public:
  void learn(const Vec3f& point_m, const Vec3f& normal, bool visible);
  /// Whether several samples near by, on the same side, were tried, and none was visible.
  bool hopeless(const Vec3f& point_m, const Vec3f& normal) const;
  /// Whether some of those near by, on the same side, were visible.
  bool mixed(const Vec3f& point_m, const Vec3f& normal) const;

 private:
  struct Tried {
    std::uint32_t samples = 0, visible = 0;
  };
  std::unordered_map<std::uint64_t, Tried> cells_;
};

}  // namespace arcbid
