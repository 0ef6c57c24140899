// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sim/certificate/free_space.hpp"
#include "sim/certificate/seen.hpp"
#include "sim/certificate/sensing.hpp"
#include "sim/certificate/sight_lines.hpp"

namespace arcbid::certificate {

/// What a search around a sample found: the first that holds.
enum class Finding : std::uint8_t {
  visible,       ///< a flyable position sees it, within all limits
  too_low,       ///< one would, were there neither floor nor ground
  unreachable,   ///< only positions that are not connected to the outside do
  out_of_range,  ///< a flyable position sees it, but only from too far (or too near)
  no_look,       ///< only at an elevation that the gimbal cannot take
  too_flat,      ///< only at too flat an angle
  occluded       ///< nothing of all this
};

/// Directions from a sample, in the frame of its normal (z).
struct Directions {
  std::vector<Vec3> steep;  ///< within the incidence limit; a multiple of eight
  std::vector<Vec3> flat;   ///< beyond it; a multiple of eight
};
Directions directions(double least_cosine, std::uint32_t steep);

/// Looks for a position that sees a sample, along many directions from it.
class Search {
 public:
  Search(const Sensing& sensing, const SightLines& lines, const FreeSpace& space, double safety_m,
         std::uint32_t directions);

  /// `turn`, in [0, 1), turns the directions about the normal.
  Finding around(const Sample& sample, double turn) const;
  std::size_t directions() const { return directions_.steep.size(); }

 private:
  /// What was found so far along one sample's directions.
  struct Found;
  struct Frame;
  void try_eight(const Sample& sample, const Frame& frame, const Vec3* local, bool is_steep,
                 Found& found) const;
  void trace(const Sample& sample, const Vec3& direction, bool is_steep, Found& found) const;

  const Sensing& sensing_;
  const SightLines& lines_;
  const FreeSpace& space_;
  const double safety_m_;
  const Directions directions_;
};

}  // namespace arcbid::certificate
