// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/arcs/airspace.hpp"
#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// The coordinator's side of an airspace: what the surface itself has to say. Kept apart from what
/// agents do with the model that is published.
class Surroundings {
 public:
  /// Throws InputError as bridge_arcs does.
  Surroundings(const Structure& structure, const CoverageSettings& settings);
  ~Surroundings();
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  double floor_m() const;

  /// The model, with an access for every arc that needs one. Arcs that cannot be reached are taken
  /// out, the others numbered anew; `warnings` says which and why.
  Airspace airspace(std::vector<Arc>& arcs, std::vector<std::string>& warnings) const;

  /// Whether a UAV may stand at `home`, rise straight up to the floor, and fly on from there.
  bool clear_home(const Vec3& home, const Airspace& airspace) const;

 private:
  struct Surface;
  std::unique_ptr<const Surface> surface_;
};

}  // namespace arcbid
