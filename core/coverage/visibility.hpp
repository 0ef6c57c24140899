// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/coverage/flyable.hpp"
#include "core/coverage/seer.hpp"

namespace arcbid {

/// Finds out which samples can be seen from anywhere that a drone may be.
class Visibility {
 public:
  /// Keeps references.
  Visibility(const Seer& seer, const Flyable& flyable, double safety_m);

  /// For each of the samples asked for whether some line of sight is free for as long as the safety
  /// distance: the others need no further thought.
  std::vector<bool> open(const std::vector<bool>& asked, unsigned threads) const;

  /// A place from which a sample is seen, and by which sensor.
  struct Witness {
    Vec3 position_m = Vec3::Zero();
    Wanted how = Wanted::no;
  };
  /// For each of these samples one that the narrowed sensor has, else one that the nominal one has,
  /// else none was found.
  std::vector<Witness> witnesses(const Seen& samples, unsigned threads) const;
  /// The same from a finer lattice alone: for samples on the rim of what can be seen.
  std::vector<Witness> rim_witnesses(const Seen& samples, unsigned threads) const;

 private:
  struct Ray {
    Vec3 direction;
    double at_m;
  };
  Vec3f direction(std::uint32_t sample, std::size_t k) const;
  bool is_open(std::uint32_t sample) const;
  void try_places(std::uint32_t sample, const std::vector<Vec3>& places, Witness& best) const;
  void from_lattice(std::uint32_t sample, int step, Witness& best) const;
  void along_directions(std::uint32_t sample, std::size_t count, Witness& best) const;
  std::size_t directions_for(std::uint32_t sample, const Seen& hopeless) const;
  unsigned hidden_from(std::uint32_t sample, const std::vector<Vec3>& places) const;
  std::optional<double> next_reached(const Vec3& from, const Vec3& direction, double from_m) const;

  const Seer& seer_;
  const Flyable& flyable_;
  double safety_m_;
  std::vector<Vec3f> cone_;  // unit directions around +z; any first part of them is spread out
};

}  // namespace arcbid
