// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/io/config.hpp"
#include "core/io/config/values.hpp"

namespace arcbid::yaml {

/// One key: reading, checking, printing and the reference are all made from it.
template <class Owner>
struct Key {
  std::string name;   ///< full: "fleet.speed_mps"; what stands before the last dot is its section
  std::string legal;  ///< what is legal, in words
  std::string meaning;
  std::function<void(const Place&, Owner&, Report&)> read;
  std::function<std::string(const Owner&)> print;  ///< YAML; empty: has no value now
  bool required = false;
  bool is_first = false;  ///< read before its section's other keys, whose defaults it sets
};

inline constexpr std::uint32_t most_agents = 64;

/// All keys of a config; the keys of one section stand together.
const std::vector<Key<Config>>& config_keys();

/// The keys of an entry of fleet.uavs.
const std::vector<Key<Uav>>& uav_keys();

/// The keys of a fleet.
std::vector<Key<FleetConfig>> fleet_keys();

/// The keys of a sensor; its kind chooses a preset, which the other keys change.
std::vector<Key<Sensor>> sensor_keys();

/// Reads a mapping: unknown, repeated and malformed keys are reported, required ones demanded.
/// Found keys are noted in the report.
template <class Owner>
void read_mapping(const Place& place, const std::vector<Key<Owner>>& keys, Owner& owner,
                  Report& report);

}  // namespace arcbid::yaml
