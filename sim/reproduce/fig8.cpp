// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "sim/auction/spread.hpp"
#include "sim/certificate/parallel.hpp"
#include "sim/reproduce/fleets.hpp"
#include "sim/reproduce/models.hpp"

namespace arcbid::reproduce {
namespace {

constexpr std::uint32_t kLeast = 2, kMost = 10;
constexpr double kAimPercent = 3;  ///< CV of flight times, for ours

constexpr Method limited(Method method, std::string_view name) {
  method.name = name;
  method.is_limited = true;
  return method;
}
constexpr Method cheap(Method method) {
  method.name = "ours, cheap";
  method.trades = TradesKind::cheap;
  return method;
}
constexpr std::array kMethods{kCbba,        limited(kCbba, "CBBA, bundle limit"),
                              kScCbba,      limited(kScCbba, "SC-CBBA, bundle limit"),
                              cheap(kOurs), kOurs};

std::vector<double> counts(const FleetRun& run) {
  return {run.flown_tasks.begin(), run.flown_tasks.end()};
}

std::vector<Cell> row_of(const char* arcs, std::uint32_t agents, const Method& method,
                         const FleetRun& run, const TaskSet& pieces) {
  return {std::string(arcs),
          static_cast<double>(agents),
          std::string(method.name),
          static_cast<double>(run.tasks),
          uniformity(pieces_flown(run, pieces)),
          uniformity(counts(run)),
          uniformity(run.times_s),
          100 * variation(run.times_s),
          *std::ranges::max_element(run.times_s),
          run.total_length_m,
          std::string(run.converged && run.agreed && run.unassigned == 0 ? "yes" : "NO")};
}

std::string lengths_text(const char* name, const BridgeArcs& bridge) {
  std::vector<double> lengths;
  for (const Arc& arc : bridge.arcs) lengths.push_back(length_m(arc.waypoints));
  return fmt::format("{} {} arcs, the longest {:.0f} m, CV of their lengths {:.0f} %", name,
                     lengths.size(), *std::ranges::max_element(lengths), 100 * variation(lengths));
}

void add_rows(Table& table, const char* arcs, const BridgeArcs& bridge, const Settings& settings) {
  constexpr std::size_t sizes = kMost - kLeast + 1;
  const TaskSet pieces = split(bridge.arcs, std::nullopt, AuctionSettings{}.max_tasks);
  std::vector<std::vector<Cell>> rows(sizes * kMethods.size());
  certificate::in_chunks(rows.size(), 1, settings.jobs, [&](std::size_t n, std::size_t) {
    const auto agents = static_cast<std::uint32_t>(kLeast + n / kMethods.size());
    const Method& method = kMethods[n % kMethods.size()];
    rows[n] = row_of(arcs, agents, method, divide(bridge, agents, method, settings.seed), pieces);
  });
  table.rows.insert(table.rows.end(), rows.begin(), rows.end());
}

Panel panel(const Table& table, std::string_view arcs, std::string title, std::string y_label,
            std::size_t column) {
  Panel out{std::move(title), "UAVs N", std::move(y_label), {}};
  for (const Method& method : kMethods) {
    Series series{std::string(method.name), {{}}, true, true, static_cast<int>(out.series.size())};
    for (const auto& row : table.rows)
      if (std::get<std::string>(row[0]) == arcs && std::get<std::string>(row[2]) == method.name)
        series.strokes[0].push_back({std::get<double>(row[1]), std::get<double>(row[column])});
    out.series.push_back(std::move(series));
  }
  return out;
}

/// The greatest CV of `ours`, and whether it is what was asked for.
std::string verdict(const Table& table) {
  double worst = 0;
  for (const auto& row : table.rows)
    if (std::get<std::string>(row[2]) == kOurs.name)
      worst = std::max(worst, std::get<double>(row[7]));
  return fmt::format(
      "Flight times of `ours` vary by at most {:.2f} % (CV), where {:.0f} % was asked "
      "for: {}.",
      worst, kAimPercent, worst <= kAimPercent ? "held" : "NOT held");
}

std::vector<std::string> differences(const Table& table) {
  return {
      verdict(table),
      "The paper prints no numbers here: its curves of SC-CBBA stay near 1 on both sets, and those "
      "of CBBA do not. E depends on the unit, and the paper does not name it. `E on pieces` counts "
      "the pieces of eq. 4 that a UAV flies, of whole arcs those that they would be cut into: one "
      "unit for all methods. `E on tasks` counts what was auctioned, which for CBBA is whole arcs "
      "however long.",
      "E is near 1 only where counts are as good as equal, and nothing in the auction asks for "
      "that: "
      "it needs a bundle limit of ceil(|T|/N), and even then the last UAV gets what is left over, "
      "which costs E where |T| is no multiple of N.",
      "Equal counts are not what a mission wants: with the limit the slowest UAV is later than "
      "without. `ours` levels flight times and lets counts be what they are."};
}

}  // namespace

Finding fig8(const Settings& settings) {
  Finding out{
      .name = "fig8",
      .title = "Fig. 8: how evenly work is divided",
      .setting = bridge_text(settings.bridge) +
                 " Slices and rows, D = 5 m; even: rows along the short side, uneven: along "
                 "the long side. Bids by MiniMax, straight legs, UAVs at 1 m/s.",
      .table = {{{"arcs", "arcs", 0},
                 {"agents", "N", 0},
                 {"method", "method", 0},
                 {"tasks", "tasks", 0},
                 {"uniformity_pieces", "E on pieces", 4},
                 {"uniformity_tasks", "E on tasks", 4},
                 {"uniformity_time", "E on times", 6},
                 {"cv_time_percent", "CV of times (%)", 2},
                 {"makespan_s", "slowest (s)", 1},
                 {"length_m", "all (m)", 0},
                 {"is_agreed", "agreed, complete", 0}},
                {}},
      .pictures = {},
      .differences = {}};
  std::string lengths;
  for (const auto& [name, rows] :
       {std::pair{"even", RowSide::short_side}, std::pair{"uneven", RowSide::long_side}}) {
    settings.tell(fmt::format("fig8: {} arcs, N = {} to {}", name, kLeast, kMost));
    const BridgeArcs bridge = make_arcs(settings, rows, settings.seed);
    lengths += (lengths.empty() ? "" : "; ") + lengths_text(name, bridge);
    add_rows(out.table, name, bridge, settings);
  }
  out.pictures = {{"fig8",
                   "E on pieces, and below it the CV of flight times",
                   2,
                   {panel(out.table, "even", "(a) even arcs", "E on pieces", 4),
                    panel(out.table, "uneven", "(b) uneven arcs", "E on pieces", 4),
                    panel(out.table, "even", "even arcs", "CV of flight times (%)", 7),
                    panel(out.table, "uneven", "uneven arcs", "CV of flight times (%)", 7)}}};
  out.differences = differences(out.table);
  out.differences.push_back(
      "The names of the sets are the paper's, for how rows are laid. On this bridge even rows are "
      "short beside the deck's outlines, so that neither set is even: " +
      lengths + ".");
  return out;
}

}  // namespace arcbid::reproduce
