// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/airspace/free_grid.hpp"

namespace arcbid {

/// A box of cells, `high` excluded.
struct CellBox {
  Cell low, high;
};

/// Breadth first from `start`, through faces, over the cells of a box that `enter(cell)` lets in.
/// `visit(cell)` is told every cell once, `start` first; it ends the search by returning true.
/// Returns the cells from the last one back to `start`, or none where nothing ended it.
template <class Enter, class Visit>
std::vector<Cell> search_cells(const CellBox& box, const Cell& start, Enter enter, Visit visit) {
  std::array<int, 3> size{};
  for (std::size_t k = 0; k < 3; ++k) size[k] = box.high[k] - box.low[k];
  const auto number = [&](const Cell& c) {
    return static_cast<std::size_t>(c[0] - box.low[0] +
                                    size[0] * (c[1] - box.low[1] + size[1] * (c[2] - box.low[2])));
  };
  struct Found {
    Cell cell;
    std::uint32_t from;
  };
  std::vector<Found> found{{start, 0}};
  std::vector<bool> seen(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  seen[number(start)] = true;
  for (std::uint32_t n = 0; n < found.size(); ++n) {
    const Cell here = found[n].cell;
    if (visit(here)) {
      std::vector<Cell> back{here};
      for (std::uint32_t at = n; at != 0; back.push_back(found[at].cell)) at = found[at].from;
      return back;
    }
    for (std::size_t k = 0; k < 3; ++k)
      for (const int step : {-1, 1}) {
        Cell next = here;
        next[k] += step;
        if (next[k] < box.low[k] || next[k] >= box.high[k]) continue;
        if (seen[number(next)] || !enter(next)) continue;
        seen[number(next)] = true;
        found.push_back({next, n});
      }
  }
  return {};
}

}  // namespace arcbid
