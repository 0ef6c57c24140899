// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/certificate/distances.hpp"

namespace arcbid::certificate {

/// What may be said of a position.
enum class Place : std::uint8_t {
  not_free,  ///< nearer than safety_m to the structure
  pocket,    ///< free, but no way out is known
  too_low,   ///< free, and one could get there if there were neither floor nor ground
  flyable    ///< free, not below the floor, and connected to the outside
};

struct FreeSpaceSettings {
  double safety_m = 2, floor_m = 0;
  double around_m = 8;  ///< how far from the structure's box positions are asked for
  double grid_m = 0.5;  ///< finest step; coarser where the box has more than 64 million cells
  unsigned threads = 0;
};

/// Where a drone can be. Distances are exact everywhere; what is connected to the outside is found
/// on a grid, every step of which was proven to keep safety_m. So `flyable` is certain, while a
/// position behind a gap that no grid line passes counts as in a pocket.
class FreeSpace {
 public:
  FreeSpace(const Structure& structure, const Distances& distances,
            const FreeSpaceSettings& settings);

  Place place(const Vec3& position) const;
  /// The best that place() may say of a position, from its cell alone. What lies in a cell whose
  /// middle is not free, and beside nothing that is connected, counts as not free.
  Place at_best(const Vec3& position) const;
  double grid_m() const { return grid_m_; }
  double floor_m() const { return settings_.floor_m; }

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct Block;
  void classify(const Block& block);
  void fill(bool with_floor);
  void spread(std::vector<Cell>& front, bool with_floor, bool proven_only,
              std::vector<Cell>& unproven);
  void try_step(const Cell& from, const Cell& to, bool with_floor, bool proven_only,
                std::vector<Cell>& front, std::vector<Cell>& unproven);
  std::vector<Cell> rim(bool with_floor) const;
  void note_neighbours();
  bool is_inside(const Cell& cell) const;
  std::size_t index(const Cell& cell) const;
  Vec3 middle(const Cell& cell) const;
  Cell cell_of(const Vec3& position) const;
  bool is_over_floor(const Cell& cell) const { return cell[2] >= floor_cell_; }
  bool keeps_clear(const Vec3& from, const Vec3& to) const;
  bool leads_out(const Vec3& position, std::uint8_t how) const;

  const Distances& distances_;
  const FreeSpaceSettings settings_;
  double grid_m_;
  Vec3 low_m_;  ///< middle of the first cell
  Cell size_;
  std::int32_t floor_cell_ = 0;  ///< the lowest level of cells that is not below the floor
  std::vector<std::uint8_t> cells_;
};

}  // namespace arcbid::certificate
