// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "sim/checker/checks.hpp"
#include "sim/checker/coverage.hpp"

namespace arcbid::checker {

namespace {

using StretchesByArc = std::map<std::uint32_t, std::vector<Stretch>>;

/// Each published arc, also one without any stretch, has to be tiled; there are no others.
void check_tiling(const Published& published, StretchesByArc stretches, const std::string& by,
                  Problems& problems) {
  for (const auto& [arc, of_arc] : stretches)
    if (!published.arcs.contains(arc))
      problems.add(fmt::format("{}: arc {} of {} was never published", by, arc, of_arc[0].whose));
  for (const auto& [id, arc] : published.arcs)
    for (const std::string& reason : why_not_tiled(stretches[id], arc.length_m))
      problems.add(fmt::format("{}: arc {} ({:.4f} m): {}", by, id, arc.length_m, reason));
}

StretchesByArc task_stretches(const Delivered& delivered, Problems& problems) {
  StretchesByArc stretches;
  for (const TaskRow& row : delivered.tasks) {
    if (row.from_m >= row.to_m)
      problems.add(fmt::format("agent {}'s table: task {} of arc {} is empty: {} to {} m",
                               delivered.agent, row.task, row.arc, row.from_m, row.to_m));
    stretches[row.arc].push_back({std::min(row.from_m, row.to_m), std::max(row.from_m, row.to_m),
                                  fmt::format("task {}", row.task)});
  }
  return stretches;
}

}  // namespace

Problems check_conservation(const Published& published, const std::vector<Delivered>& all) {
  Problems problems;
  for (const Delivered& delivered : all) {
    if (&delivered != &all[0] && delivered.tasks == all[0].tasks) continue;
    check_tiling(published, task_stretches(delivered, problems),
                 fmt::format("split, agent {}'s table", delivered.agent), problems);
  }
  StretchesByArc flown;
  for (const Delivered& delivered : all)
    for (const Leg& leg : delivered.legs)
      if (leg.arc)
        flown[*leg.arc].push_back({std::min(leg.from_m, leg.to_m), std::max(leg.from_m, leg.to_m),
                                   fmt::format("agent {}", delivered.agent)});
  for (const Left& left : all[0].left)
    flown[left.arc].push_back(
        {std::min(left.from_m, left.to_m), std::max(left.from_m, left.to_m), "nobody, as is said"});
  check_tiling(published, std::move(flown), "combine, all routes", problems);
  return problems;
}

}  // namespace arcbid::checker
