// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/faults/link_model.hpp"

namespace arcbid {

inline constexpr TimeNs ms = 1'000'000;
inline constexpr TimeNs s = 1000 * ms;

/// Agents 1 to n, 10 m apart along x.
inline std::vector<Uav> row_of(std::uint32_t n) {
  std::vector<Uav> fleet;
  for (std::uint32_t i = 1; i <= n; ++i) fleet.push_back({{i}, Vec3(10.0 * i, 0, 0), 1});
  return fleet;
}

inline FaultSchedule with(const LinkFault& fault, std::uint64_t seed = 1) {
  FaultSchedule schedule;
  schedule.seed = seed;
  schedule.links = {fault};
  return schedule;
}

/// The link from agent 1 to agent 2 of three.
inline LinkModel link(const FaultSchedule& schedule, std::uint32_t from = 1, std::uint32_t to = 2) {
  return {schedule, row_of(3), {from}, {to}};
}

/// Whether each of messages 1 to n, 100 bytes long, is lost.
inline std::vector<bool> losses(LinkModel model, std::uint64_t n, std::uint64_t bytes = 100) {
  std::vector<bool> lost;
  for (std::uint64_t i = 1; i <= n; ++i)
    lost.push_back(model.send(i, bytes, static_cast<TimeNs>(i) * ms).arrivals_ns.empty());
  return lost;
}

inline double share(const std::vector<bool>& lost) {
  std::size_t count = 0;
  for (const bool l : lost) count += l ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(lost.size());
}

/// Mean length of the runs of losses.
inline double mean_run(const std::vector<bool>& lost) {
  std::size_t count = 0, runs = 0;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    count += lost[i] ? 1 : 0;
    runs += lost[i] && (i == 0 || !lost[i - 1]) ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(runs);
}

}  // namespace arcbid
