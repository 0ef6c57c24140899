// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/checker/geometry.hpp"

namespace arcbid::checker {

struct FleetAgent {
  Point home_m;
  double speed_mps = 0;
};

struct PublishedArc {
  Path waypoints;
  double length_m = 0;  ///< recomputed from the waypoints
};

/// RUN/arcs.json. Ordered by id.
struct Published {
  std::string mission;
  std::map<std::uint32_t, FleetAgent> fleet;
  std::map<std::uint32_t, PublishedArc> arcs;
};

struct TaskRow {
  std::uint32_t task = 0, arc = 0;
  double from_m = 0, to_m = 0;
  std::optional<std::uint32_t> owner;
  std::optional<double> bid;
  friend bool operator==(const TaskRow&, const TaskRow&) = default;
};

struct Leg {
  std::optional<std::uint32_t> arc;  ///< none: transit
  double from_m = 0, to_m = 0;       ///< from_m > to_m: flown backwards
  Path waypoints;
};

/// RUN/routes/agent_N.json.
struct Delivered {
  std::uint32_t agent = 0;
  std::string mission, view_hash;
  std::vector<TaskRow> tasks;  ///< ascending ids
  double length_m = 0, time_s = 0;
  std::vector<Leg> legs;
};

/// Throws DamagedFile.
Published read_published(const std::filesystem::path& file);

/// Throws DamagedFile, also when the file is not named after its agent.
Delivered read_delivered(const std::filesystem::path& file);

/// The files of RUN/routes, sorted by name, without those half-written (*.part); empty when there
/// is no such folder.
std::vector<std::filesystem::path> route_files(const std::filesystem::path& run);

}  // namespace arcbid::checker
