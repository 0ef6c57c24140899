// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/checker/checker.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/checker/checks.hpp"
#include "sim/checker/json_field.hpp"

namespace arcbid {

namespace {

using namespace checker;

/// Appends a check's problems to the report; true when there are none.
bool verdict(const char* check, const Problems& problems, CheckReport& report) {
  for (const std::string& line : problems.lines())
    report.problems.push_back(fmt::format("{}: {}", check, line));
  if (const std::size_t hidden = problems.count() - problems.lines().size(); hidden > 0)
    report.problems.push_back(fmt::format("{}: and {} more", check, hidden));
  return problems.none();
}

/// E = N / (sum (T_i - mu)^2 + N): Equation (18).
double uniformity(const std::vector<double>& shares) {
  if (shares.empty()) return 0;
  const double count = static_cast<double>(shares.size());
  double mean = 0, squares = 0;
  for (const double share : shares) mean += share / count;
  for (const double share : shares) squares += (share - mean) * (share - mean);
  return count / (squares + count);
}

void add_figures(const Published& published, const std::vector<Delivered>& all,
                 CheckReport& report) {
  std::vector<double> tasks_won, times_s;
  for (const Delivered& delivered : all) {
    AgentFigures figures{.agent = delivered.agent, .length_m = flown_m(delivered)};
    for (const Leg& leg : delivered.legs) figures.arcs += leg.arc.has_value();
    for (const TaskRow& row : delivered.tasks) figures.tasks += row.owner == delivered.agent;
    if (const auto uav = published.fleet.find(delivered.agent); uav != published.fleet.end())
      figures.time_s = figures.length_m / uav->second.speed_mps;
    tasks_won.push_back(static_cast<double>(figures.tasks));
    times_s.push_back(figures.time_s);
    report.makespan_s = std::max(report.makespan_s, figures.time_s);
    report.total_length_m += figures.length_m;
    report.per_agent.push_back(figures);
  }
  report.uniformity_count = uniformity(tasks_won);
  report.uniformity_time = uniformity(times_s);
  report.arcs = published.arcs.size();
  report.tasks = all.empty() ? 0 : all[0].tasks.size();
  report.agents = all.size();
}

std::vector<Delivered> read_routes(const std::filesystem::path& run, Problems& problems) {
  std::vector<Delivered> all;
  for (const std::filesystem::path& file : route_files(run)) {
    try {
      all.push_back(read_delivered(file));
    } catch (const DamagedFile& e) {
      problems.add(fmt::format("routes/{}: {}", file.filename().string(), e.what()));
    }
  }
  std::ranges::sort(all, {}, &Delivered::agent);
  return all;
}

}  // namespace

double CheckReport::left_m() const {
  double sum_m = 0;
  for (const LeftUndone& one : left) sum_m += one.to_m - one.from_m;
  return sum_m;
}

CheckReport check_run(const std::filesystem::path& run) {
  CheckReport report;
  Published published;
  try {
    published = read_published(run / "arcs.json");
  } catch (const DamagedFile& e) {
    report.problems.push_back(fmt::format("arcs.json: {}", e.what()));
    return report;
  }
  Problems route_problems;
  const std::vector<Delivered> all = read_routes(run, route_problems);
  add_figures(published, all, report);
  if (all.empty()) {
    verdict("routes_valid", route_problems, report);
    report.problems.push_back("complete: no agent delivered a readable route in routes/");
    return report;
  }
  for (const Delivered& delivered : all) check_route(published, delivered, route_problems);
  report.conflict_free = verdict("conflict_free", check_conflicts(all), report);
  Problems incomplete = check_completeness(all);
  check_left(published, all, incomplete);
  report.complete = verdict("complete", incomplete, report);
  for (const Left& left : all[0].left)
    report.left.push_back({left.arc, left.from_m, left.to_m, left.why, left.text});
  report.arcs_conserved = verdict("arcs_conserved", check_conservation(published, all), report);
  report.routes_valid = verdict("routes_valid", route_problems, report);
  return report;
}

}  // namespace arcbid
