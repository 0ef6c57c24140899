// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/roadmap.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/airspace/cell_search.hpp"
#include "core/airspace/corridors.hpp"
#include "core/airspace/pull.hpp"

namespace arcbid {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

CellBox joined(const CellBox& a, const CellBox& b) {
  CellBox out = a;
  for (std::size_t k = 0; k < 3; ++k) {
    out.low[k] = std::min(a.low[k], b.low[k]);
    out.high[k] = std::max(a.high[k], b.high[k]);
  }
  return out;
}

CellBox cells_of(const Cell& block, int side, const Cell& size) {
  CellBox out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.low[k] = block[k] * side;
    out.high[k] = std::min(size[k], out.low[k] + side);
  }
  return out;
}

template <class Visit>
void for_each_cell(const CellBox& box, Visit visit) {
  for (int z = box.low[2]; z < box.high[2]; ++z)
    for (int y = box.low[1]; y < box.high[1]; ++y)
      for (int x = box.low[0]; x < box.high[0]; ++x) visit(Cell{x, y, z});
}

/// Twice the distance of a cell from the middle of its block, squared.
int off_middle(const Cell& c, const CellBox& box) {
  int sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int off = 2 * c[k] + 1 - box.low[k] - box.high[k];
    sum += off * off;
  }
  return sum;
}

}  // namespace

Roadmap::Roadmap(const FreeGrid& grid, std::size_t most_blocks) : grid_(grid) {
  for (;; ++side_) {
    std::size_t total = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      blocks_[k] = (grid.size()[k] + side_ - 1) / side_;
      total *= static_cast<std::size_t>(blocks_[k]);
    }
    if (total <= most_blocks) break;
  }
  std::vector<std::uint32_t> label(grid.number({0, 0, grid.size()[2]}), kNone);
  const CellBox all{{0, 0, 0}, blocks_};
  for_each_cell(all, [&](const Cell& block) { label_block(block, label); });
  first_node_.push_back(static_cast<std::uint32_t>(nodes_.size()));
  for_each_cell(all, [&](const Cell& block) { link_block(block, label); });
  sort_edges();
}

std::size_t Roadmap::block_number(const Cell& block) const {
  return static_cast<std::size_t>(block[0] + blocks_[0] * (block[1] + blocks_[1] * block[2]));
}

Cell Roadmap::block_of(const Cell& cell) const {
  return {cell[0] / side_, cell[1] / side_, cell[2] / side_};
}

/// Gives each part of the block a node: its cell nearest to the middle.
void Roadmap::label_block(const Cell& block, std::vector<std::uint32_t>& label) {
  first_node_.push_back(static_cast<std::uint32_t>(nodes_.size()));
  const CellBox box = cells_of(block, side_, grid_.size());
  for_each_cell(box, [&](const Cell& start) {
    if (!grid_.free(start) || label[grid_.number(start)] != kNone) return;
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    Cell middle = start;
    search_cells(
        box, start, [&](const Cell& c) { return grid_.free(c); },
        [&](const Cell& c) {
          label[grid_.number(c)] = node;
          if (off_middle(c, box) < off_middle(middle, box)) middle = c;
          return false;
        });
    node_cells_.push_back(middle);
    nodes_.push_back(grid_.centre(middle));
  });
}

/// To the blocks that come later: half of the 26 around it.
void Roadmap::link_block(const Cell& block, const std::vector<std::uint32_t>& label) {
  const std::size_t own = block_number(block);
  for (int n = 14; n < 27; ++n) {
    const Cell other{block[0] + n % 3 - 1, block[1] + n / 3 % 3 - 1, block[2] + n / 9 - 1};
    bool holds = true;
    for (std::size_t k = 0; k < 3; ++k) holds = holds && other[k] >= 0 && other[k] < blocks_[k];
    if (!holds) continue;
    const bool shares_face = n == 14 || n == 16 || n == 22;
    const std::size_t theirs = block_number(other);
    for (std::uint32_t a = first_node_[own]; a < first_node_[own + 1]; ++a)
      for (std::uint32_t b = first_node_[theirs]; b < first_node_[theirs + 1]; ++b) {
        if (grid_.sees(nodes_[a], nodes_[b]))
          link(a, b);
        else if (shares_face)
          link_by_cells(a, b, label);
      }
  }
}

/// Where the two parts touch, over the fewest cells, straightened; its bends are nodes too.
void Roadmap::link_by_cells(std::uint32_t a, std::uint32_t b,
                            const std::vector<std::uint32_t>& label) {
  const CellBox box = joined(cells_of(block_of(node_cells_[a]), side_, grid_.size()),
                             cells_of(block_of(node_cells_[b]), side_, grid_.size()));
  const auto back = search_cells(
      box, node_cells_[b],
      [&](const Cell& c) {
        const std::uint32_t of = label[grid_.number(c)];
        return of == a || of == b;
      },
      [&](const Cell& c) { return c == node_cells_[a]; });
  if (back.empty()) return;
  std::vector<Vec3> way;
  for (const Cell& c : back) way.push_back(grid_.centre(c));
  shorten(grid_, way);
  std::uint32_t last = a;
  for (std::size_t n = 1; n + 1 < way.size(); ++n) {
    nodes_.push_back(way[n]);
    const auto bend = static_cast<std::uint32_t>(nodes_.size() - 1);
    link(last, bend);
    last = bend;
  }
  link(last, b);
}

void Roadmap::link(std::uint32_t a, std::uint32_t b) {
  pairs_.push_back({a, b});
  pairs_.push_back({b, a});
}

void Roadmap::sort_edges() {
  first_edge_.assign(nodes_.size() + 1, 0);
  for (const Pair& pair : pairs_) ++first_edge_[pair.a + 1];
  for (std::size_t n = 0; n < nodes_.size(); ++n) first_edge_[n + 1] += first_edge_[n];
  edges_.resize(pairs_.size());
  std::vector<std::uint32_t> at = first_edge_;
  for (const Pair& pair : pairs_)
    edges_[at[pair.a]++] = {pair.b, (nodes_[pair.b] - nodes_[pair.a]).norm()};
  pairs_ = {};
}

/// The node that is this cell of a block.
std::uint32_t Roadmap::node_at(const Cell& cell) const {
  const std::size_t block = block_number(block_of(cell));
  for (std::uint32_t n = first_node_[block]; n < first_node_[block + 1]; ++n)
    if (node_cells_[n] == cell) return n;
  return kNone;
}

std::vector<Roadmap::Link> Roadmap::links(const Vec3& free_point) const {
  const Vec3 entry = grid_.clamped(free_point);
  const Cell cell = grid_.cell(entry), block = block_of(cell);
  std::uint32_t own = kNone;
  const auto back = search_cells(
      cells_of(block, side_, grid_.size()), cell, [&](const Cell& c) { return grid_.free(c); },
      [&](const Cell& c) { return (own = node_at(c)) != kNone; });
  std::vector<Link> out;
  for (int n = 0; n < 27; ++n) {
    const Cell other{block[0] + n % 3 - 1, block[1] + n / 3 % 3 - 1, block[2] + n / 9 - 1};
    bool holds = true;
    for (std::size_t k = 0; k < 3; ++k) holds = holds && other[k] >= 0 && other[k] < blocks_[k];
    if (!holds) continue;
    const std::size_t b = block_number(other);
    for (std::uint32_t node = first_node_[b]; node < first_node_[b + 1]; ++node)
      if (grid_.sees(free_point, nodes_[node])) {
        out.push_back({node, (nodes_[node] - free_point).norm(), {}});
        if (node == own) own = kNone;
      }
  }
  if (back.empty() || own == kNone) return out;
  std::vector<Vec3> way{free_point, entry};
  for (auto c = back.rbegin(); c != back.rend(); ++c) way.push_back(grid_.centre(*c));
  shorten(grid_, way);
  const double length_m = way_length_m(way);
  out.push_back({own, length_m, {way.begin() + 1, way.end() - 1}});
  return out;
}

}  // namespace arcbid
