// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/airspace/corridors.hpp"
#include "core/airspace/free_grid.hpp"
#include "core/airspace/roadmap.hpp"
#include "core/airspace/search.hpp"
#include "core/arcs/airspace.hpp"

namespace arcbid {

/// Legs around the obstacles of a published model: straight where that is free, else the shortest
/// way found. Whoever builds it from the same model, arcs and places has the same lengths and ways,
/// bit for bit. Lengths are the same there and back; the triangle inequality holds up to what the
/// search for ways loses (docs/AIRSPACE.md). Between places that do not hang together, which a
/// coordinator's model has none of, legs are straight.
class ObstacleTransit final : public Transit {
 public:
  /// `places`: where legs will begin and end; in any order, repeated or not. Their lengths are
  /// worked out here, by `threads` threads (0: as many as the machine has), so that asking is
  /// looking up. Keeps a copy of `arcs` and `airspace`, which must be sound and not empty.
  /// `table`: of a transit that was made from the same; of another size it is worked out again.
  ObstacleTransit(const Airspace& airspace, const std::vector<Arc>& arcs,
                  std::span<const Vec3> places, unsigned threads = 0,
                  std::vector<double> table = {});

  double length_m(const Vec3& from, const Vec3& to) const override;
  std::uint32_t place(const Vec3& point) const override;
  void lengths_m(const Vec3& from, const Points& to, double* out) const override;
  void lengths_m(const Points& from, const Vec3& to, double* out) const override;
  std::vector<Vec3> way(const Vec3& from, const Vec3& to) const override;

  /// Places no leg can leave: neither free, nor on an arc with a way out, nor under a free column.
  std::vector<Vec3> closed_in() const;
  const FreeGrid& grid() const { return grid_; }
  /// All lengths between places, for who makes the same transit again.
  const std::vector<double>& table() const { return lengths_m_; }

 private:
  struct Place {
    Vec3 at;
    std::optional<OnArc> on;  // where no cell is free
    std::vector<LinkedDoor> doors;
  };

  Place make_place(const Vec3& at) const;
  std::vector<Vec3> leg(Search& search, const Place& from, const Place& to) const;
  void fill_table(unsigned threads);
  void index_places();

  std::vector<Arc> arcs_;
  Airspace airspace_;
  FreeGrid grid_;
  Corridors corridors_;
  Roadmap roadmap_;
  std::vector<Place> places_;         // ascending by x, y, z; each once
  std::vector<std::uint32_t> slots_;  // a hash table of places, open addressing
  std::vector<double> lengths_m_;     // places x places
};

}  // namespace arcbid
