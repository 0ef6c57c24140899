// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/arcs/arc.hpp"

namespace arcbid {

/// The output layer of the SOM: neurons W_1 ... W_J in 3-D, closed to a ring that grows.
/// Positions are in whatever unit the inputs have.
class GrowingRing {
 public:
  /// `neurons` >= 3 of them, evenly on a horizontal circle.
  GrowingRing(std::size_t neurons, const Vec3& centre, double radius);

  /// J.
  std::size_t size() const { return x_.size(); }

  /// X(A): the neuron nearest to `input`; of equally near ones the first (eq. 12).
  std::size_t winner(const Vec3& input);

  /// Draws the winner and its neighbours along the ring toward `input` and counts the win
  /// (eqs. 13, 14). `sigma` is in neurons; d_j is the number of neurons between j and the winner.
  void pull(std::size_t winner, const Vec3& input, double eta, double sigma);

  /// J(t + dt) = J(t) + 1 (eq. 15): a new neuron between the one that wins most and its farther
  /// neighbour, half-way. The two share the wins from then on. Ties: the first neuron, the
  /// neighbour that follows it.
  void grow();

  /// How far along the ring `input` lies, compared with its winner: orders inputs of one winner.
  double along(std::size_t winner, const Vec3& input) const;

 private:
  Vec3 position(std::size_t neuron) const { return {x_[neuron], y_[neuron], z_[neuron]}; }
  std::size_t next(std::size_t neuron) const { return neuron + 1 == size() ? 0 : neuron + 1; }
  std::size_t previous(std::size_t neuron) const { return (neuron == 0 ? size() : neuron) - 1; }
  void insert(std::size_t at, const Vec3& position, double wins);
  void move(std::size_t neuron, const Vec3& input, double fraction);

  // One array a coordinate: the search for the winner is most of the run time, and so it
  // vectorises.
  std::vector<double> x_, y_, z_;
  std::vector<double> wins_;
  std::vector<double> squared_distance_;
};

}  // namespace arcbid
