// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/coverage/scene.hpp"

namespace arcbid {

/// Where a drone may be: safety_m from the surface (exactly, but for a few millimetres), above the
/// floor, and where it can come from outside. All in the surface's frame.
class Flyable {
 public:
  struct Limits {
    double safety_m, floor_z_m;
    double around_m;  ///< how far beyond the structure a drone may have to be
  };
  Flyable(const Scene& scene, const Surface& surface, const Limits& limits, unsigned threads);

  /// Whether all of the segment may be flown, checked continuously; connection is not asked.
  bool clears(const Vec3& from, const Vec3& to) const;
  bool clears(const Vec3& p) const { return p.z() >= floor_m_ && spare_m(p) >= 0; }

  /// Whether p may be flown and there is a way to it from outside.
  bool reaches(const Vec3& p) const;

  /// Distance beyond what is required; exact up to the required distance, at most `most_m`.
  double spare_m(const Vec3& p, double most_m = 4.0) const;

  /// Grid positions that can be reached, `step` cells apart along each axis, near the surface.
  double cell_m() const { return cell_m_; }
  using Cell = std::array<int, 3>;
  Cell cell_of(const Vec3& p) const {
    // Rounded down without a call; what is below the grid stays below it.
    const Vec3 at = (p - low_m_) / cell_m_ + Vec3::Ones();
    return {static_cast<int>(at.x()) - 1, static_cast<int>(at.y()) - 1,
            static_cast<int>(at.z()) - 1};
  }
  Vec3 centre(const Cell& c) const;
  bool reached(const Cell& c) const { return inside(c) && state_[index(c)] == kReached; }
  bool inside(const Cell& c) const {
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < cells_[0] && c[1] < cells_[1] &&
           c[2] < cells_[2];
  }
  double floor_m() const { return floor_m_; }

 private:
  enum State : std::uint8_t { kUnknown, kBlocked, kTight, kOpen, kReached };

  std::size_t index(const Cell& c) const {
    return (static_cast<std::size_t>(c[2]) * static_cast<std::size_t>(cells_[1]) +
            static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(cells_[0]) +
           static_cast<std::size_t>(c[0]);
  }
  void classify(const Cell& low, int size);
  void classify_all(unsigned threads);
  void flood();
  bool linked(const Cell& from, State from_state, const Cell& to, State to_state) const;

  const Scene& scene_;
  double required_m_, floor_m_, cell_m_;
  Vec3 low_m_;
  Cell cells_;
  std::vector<State> state_;
};

}  // namespace arcbid
