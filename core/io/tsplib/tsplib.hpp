// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/tour/tour.hpp"

namespace arcbid {

/// Cities of a TSPLIB instance (Reinelt 1991), joined to arcs by pairs.
struct PairedCities {
  std::vector<TourArc> arcs;                        ///< straight, in the instance's unit
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< by arc: the cities at its ends
};

/// Reads the coordinates of `tsp` (NODE_COORD_SECTION, two or three of them; what its metric rounds
/// is not read) and `pairs`: two cities a line; a line that begins with # is a comment, but for
/// "# node N is a duplicate of node K", which adds a city. Every city must be in one pair. Throws
/// InputError.
PairedCities read_paired_cities(const std::filesystem::path& tsp,
                                const std::filesystem::path& pairs);

/// The cities alone, by ascending numbers. Throws InputError.
std::vector<Vec3> read_cities(const std::filesystem::path& tsp);

}  // namespace arcbid
