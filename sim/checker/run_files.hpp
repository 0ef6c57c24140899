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
  std::optional<double> endurance_s;
  std::string payload = "any";
  bool serves(const std::string& needed) const {
    return payload == needed || payload == "any" || needed == "any";
  }
};

struct PublishedArc {
  Path waypoints;
  std::string payload = "any";
  double length_m = 0;  ///< recomputed from the waypoints
};

/// RUN/arcs.json. Ordered by id.
struct Published {
  std::string mission;
  std::map<std::uint32_t, FleetAgent> fleet;
  std::map<std::uint32_t, PublishedArc> arcs;
  bool transits_are_straight = false;
};

struct TaskRow {
  std::uint32_t task = 0, arc = 0;
  double from_m = 0, to_m = 0;
  std::optional<std::uint32_t> owner;   ///< flies it, after exchanges
  std::optional<std::uint32_t> won_by;  ///< won it in the auction
  std::optional<double> bid;
  friend bool operator==(const TaskRow&, const TaskRow&) = default;
};

/// A stretch that nobody flies, and why, by the word of those who agreed.
struct Left {
  std::uint32_t arc = 0;
  double from_m = 0, to_m = 0;
  std::string why, needs;
  std::optional<std::uint32_t> agent;  ///< whose endurance comes nearest
  double needed_s = 0, endurance_s = 0;
  std::uint32_t limit = 0;
  std::string text;
  friend bool operator==(const Left&, const Left&) = default;
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
  std::vector<Left> left;
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
