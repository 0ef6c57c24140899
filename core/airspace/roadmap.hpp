// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/airspace/free_grid.hpp"

namespace arcbid {

/// A graph over the free cells. The grid is cut into blocks; every part of a block whose free cells
/// hang together within it has a node. Nodes of neighbouring blocks that see each other are linked,
/// and where parts touch without that, a way through their cells links them: whatever hangs
/// together in the grid does so here.
class Roadmap {
 public:
  struct Edge {
    std::uint32_t to;
    double length_m;
  };
  /// From a point to a node: straight, or over the points between.
  struct Link {
    std::uint32_t node;
    double length_m;
    std::vector<Vec3> between;
  };

  /// Keeps a reference to the grid. Blocks grow until there are at most `most_blocks`.
  explicit Roadmap(const FreeGrid& grid, std::size_t most_blocks = 3000);

  std::size_t size() const { return nodes_.size(); }
  const Vec3& node(std::uint32_t n) const { return nodes_[n]; }
  std::span<const Edge> edges(std::uint32_t n) const {
    return {edges_.data() + first_edge_[n], edges_.data() + first_edge_[n + 1]};
  }

  /// Of a free point: to all nodes in sight in its block and those around, and at least to the one
  /// that its cell hangs together with.
  std::vector<Link> links(const Vec3& free_point) const;

 private:
  struct Pair {
    std::uint32_t a, b;
  };
  std::size_t block_number(const Cell& block) const;
  Cell block_of(const Cell& cell) const;
  std::uint32_t node_at(const Cell& cell) const;
  void label_block(const Cell& block, std::vector<std::uint32_t>& label);
  void link_block(const Cell& block, const std::vector<std::uint32_t>& label);
  void link_by_cells(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& label);
  void link(std::uint32_t a, std::uint32_t b);
  void sort_edges();

  const FreeGrid& grid_;
  int side_ = 6;  // of a block, in cells
  Cell blocks_{};
  std::vector<std::uint32_t> first_node_;  // by block; one more than there are blocks
  std::vector<Cell> node_cells_;           // of the nodes of blocks
  std::vector<Vec3> nodes_;                // those of blocks, then bends of ways between
  std::vector<Pair> pairs_;                // linked, while the roadmap is made
  std::vector<std::uint32_t> first_edge_;
  std::vector<Edge> edges_;
};

}  // namespace arcbid
