// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/route/exchanged.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcbid {
namespace {

constexpr std::size_t most_lots = 2000;  // a table of legs of 64 MB
constexpr double lots_each = 8;          // at least, in what one UAV flies without transits

/// Tasks `first` to `last`: neighbours on one arc.
struct Run {
  std::uint32_t first, last;
};

/// By task: who flies it, where in the path, and which way.
struct Flown {
  bool is_flown = false, reversed = false;
  std::uint32_t owner = 0, place = 0;
};

std::vector<Flown> flown_by(const TaskSet& set, const std::vector<std::vector<PathStop>>& paths) {
  std::vector<Flown> flown(set.tasks.size());
  for (std::uint32_t a = 0; a < paths.size(); ++a)
    for (std::uint32_t k = 0; k < paths[a].size(); ++k)
      flown[paths[a][k].task.value] = {true, paths[a][k].reversed, a, k};
  return flown;
}

/// Cuts what lies together on one arc into equal parts, as far as its tasks allow that.
void cut(const TaskSet& set, Run whole, double most_m, std::vector<Run>& runs) {
  const double begin_m = set.tasks[whole.first].from_m, end_m = set.tasks[whole.last].to_m;
  const double parts = std::max(1.0, std::ceil((end_m - begin_m) / most_m));
  const double part_m = (end_m - begin_m) / parts;
  std::uint32_t first = whole.first;
  double next_m = begin_m + part_m;
  for (std::uint32_t j = whole.first; j <= whole.last; ++j) {
    const Task& task = set.tasks[j];
    if (j < whole.last && task.to_m + 0.5 * set.tasks[j + 1].length_m() < next_m) continue;
    runs.push_back({first, j});
    first = j + 1;
    while (next_m <= task.to_m) next_m += part_m;
  }
}

std::vector<Run> runs_of(const TaskSet& set, const std::vector<Flown>& flown, std::size_t fleet) {
  double sum_m = 0;
  for (const Task& task : set.tasks) sum_m += task.length_m();
  const double most_m = sum_m / (lots_each * static_cast<double>(fleet));
  std::vector<Run> runs;
  const auto size = static_cast<std::uint32_t>(set.tasks.size());
  for (std::uint32_t first = 0; first < size; ++first) {
    if (!flown[first].is_flown) continue;
    std::uint32_t last = first;
    while (last + 1 < size && flown[last + 1].is_flown && set.same_arc({first}, {last + 1})) ++last;
    cut(set, {first, last}, most_m, runs);
    first = last;
  }
  return runs;
}

/// Each run with who flies most of it, in the order in which they come to their part of it.
Allocation start_of(const TaskSet& set, const std::vector<Flown>& flown,
                    const std::vector<Run>& runs, std::size_t fleet) {
  std::vector<std::vector<std::pair<std::uint32_t, LotStop>>> placed(fleet);
  for (std::uint32_t lot = 0; lot < runs.size(); ++lot) {
    std::vector<double> shares_m(fleet);
    for (std::uint32_t j = runs[lot].first; j <= runs[lot].last; ++j)
      shares_m[flown[j].owner] += set.tasks[j].length_m();
    const auto most = std::max_element(shares_m.begin(), shares_m.end()) - shares_m.begin();
    const auto owner = static_cast<std::uint32_t>(most);
    Flown earliest{};
    earliest.place = UINT32_MAX;
    for (std::uint32_t j = runs[lot].first; j <= runs[lot].last; ++j)
      if (flown[j].owner == owner && flown[j].place < earliest.place) earliest = flown[j];
    placed[owner].push_back({earliest.place, {lot, earliest.reversed}});
  }
  Allocation start(fleet);
  for (std::size_t a = 0; a < fleet; ++a) {
    std::ranges::sort(placed[a], {}, [](const auto& entry) { return entry.first; });
    for (const auto& [place, stop] : placed[a]) start[a].push_back(stop);
  }
  return start;
}

std::vector<Lot> lots_of(const Mission& mission, const TaskSet& set, const std::vector<Run>& runs) {
  std::vector<Lot> lots;
  for (const Run& run : runs) {
    Lot lot{set.tasks[run.first].first_m, set.tasks[run.last].last_m, 0, run.last - run.first + 1,
            mission.arcs[set.tasks[run.first].arc.value].payload};
    for (std::uint32_t j = run.first; j <= run.last; ++j) lot.length_m += set.tasks[j].length_m();
    lots.push_back(lot);
  }
  return lots;
}

std::vector<Trader> traders_of(const Mission& mission, const std::vector<Uav>& members) {
  std::vector<Trader> traders;
  for (const Uav& uav : members) {
    Trader& trader = traders.emplace_back();
    trader.home_m = uav.home_m;
    trader.speed_mps = uav.speed_mps;
    trader.endurance_s = uav.endurance_s.value_or(trader.endurance_s);
    trader.payload = uav.payload;
    if (mission.auction.bundle_limit > 0) trader.most_tasks = mission.auction.bundle_limit;
  }
  return traders;
}

std::vector<PathStop> path_of(const std::vector<LotStop>& stops, const std::vector<Run>& runs) {
  std::vector<PathStop> path;
  for (const LotStop& stop : stops) {
    const Run& run = runs[stop.lot];
    for (std::uint32_t j = run.first; j <= run.last; ++j)
      path.push_back({{stop.reversed ? run.last - (j - run.first) : j}, stop.reversed});
  }
  return path;
}

/// How long the slowest takes for what it won, each task by itself.
double slowest_as_won_s(const std::vector<Trader>& traders, const TaskSet& set,
                        const std::vector<std::vector<PathStop>>& won, const Transit& transit) {
  std::vector<Lot> tasks;
  for (const Task& task : set.tasks) tasks.push_back({task.first_m, task.last_m, task.length_m()});
  Allocation as_won(won.size());
  for (std::size_t a = 0; a < won.size(); ++a)
    for (const PathStop& stop : won[a]) as_won[a].push_back({stop.task.value, stop.reversed});
  return std::ranges::max(times_s(traders, tasks, as_won, transit));
}

}  // namespace

FleetPaths exchanged(const Mission& mission, const std::vector<Uav>& members, const TaskSet& set,
                     std::vector<std::vector<PathStop>> won, const Transit& transit,
                     const StillWanted& wanted) {
  const TradesKind kind = mission.auction.trades;
  const std::vector<Flown> flown = flown_by(set, won);
  const std::vector<Run> runs = runs_of(set, flown, members.size());
  if (kind == TradesKind::off || runs.empty() || runs.size() > most_lots) return {std::move(won)};
  const std::vector<Trader> traders = traders_of(mission, members);
  const std::vector<Lot> lots = lots_of(mission, set, runs);
  Exchanges exchanges(traders, lots, start_of(set, flown, runs, members.size()), transit, kind,
                      mission.tour.seed);
  while (!exchanges.done()) {
    if (wanted && !wanted()) return {std::move(won)};
    exchanges.step();
  }

  const std::vector<double> after_s = times_s(traders, lots, exchanges.best(), transit);
  const bool is_better = std::ranges::max(after_s) < slowest_as_won_s(traders, set, won, transit) &&
                         keeps_limits(traders, lots, exchanges.best(), after_s);
  if (!is_better) return {std::move(won)};
  FleetPaths after{{}, exchanges.count(), true};
  for (const auto& stops : exchanges.best()) after.paths.push_back(path_of(stops, runs));
  return after;
}

}  // namespace arcbid
