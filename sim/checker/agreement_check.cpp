// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sim/checker/checks.hpp"

namespace arcbid::checker {

namespace {

std::string owner_text(const TaskRow& row) {
  return row.owner ? fmt::format("agent {}", *row.owner) : "nobody";
}

std::string row_text(const TaskRow& row) {
  return fmt::format("arc {} {} to {} m, {}, bid {}", row.arc, row.from_m, row.to_m,
                     owner_text(row), row.bid ? fmt::format("{}", *row.bid) : "none");
}

void check_rows_once(const Delivered& delivered, Problems& problems) {
  const std::vector<TaskRow>& rows = delivered.tasks;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (rows[k - 1].task == rows[k].task)
      problems.add(fmt::format("agent {}: task {} is in its table twice, for {} and {}",
                               delivered.agent, rows[k].task, owner_text(rows[k - 1]),
                               owner_text(rows[k])));
}

void compare(const Delivered& one, const Delivered& other, Problems& problems) {
  if (one.view_hash != other.view_hash)
    problems.add(fmt::format("agents {} and {} agreed under different views: {} and {}", one.agent,
                             other.agent, one.view_hash, other.view_hash));
  if (one.tasks.size() != other.tasks.size())
    problems.add(fmt::format("agent {} knows {} tasks, agent {} knows {}", one.agent,
                             one.tasks.size(), other.agent, other.tasks.size()));
  if (one.left != other.left)
    problems.add(
        fmt::format("agents {} and {} differ on what has no bidder", one.agent, other.agent));
  const std::size_t rows = std::min(one.tasks.size(), other.tasks.size());
  for (std::size_t k = 0; k < rows; ++k) {
    const TaskRow &a = one.tasks[k], &b = other.tasks[k];
    if (a != b)
      problems.add(fmt::format("agent {} holds task {} ({}), agent {} holds task {} ({})",
                               one.agent, a.task, row_text(a), other.agent, b.task, row_text(b)));
  }
}

}  // namespace

Problems check_conflicts(const std::vector<Delivered>& all) {
  Problems problems;
  for (const Delivered& delivered : all) check_rows_once(delivered, problems);
  for (std::size_t i = 1; i < all.size(); ++i) compare(all[0], all[i], problems);
  return problems;
}

Problems check_completeness(const std::vector<Delivered>& all) {
  std::set<std::uint32_t> living;
  for (const Delivered& delivered : all) living.insert(delivered.agent);
  Problems problems;
  const auto check_row = [&](const Delivered& holder, const TaskRow& row) {
    const std::string where = fmt::format("agent {}'s table: task {} (arc {} {} to {} m)",
                                          holder.agent, row.task, row.arc, row.from_m, row.to_m);
    const bool is_said = std::ranges::any_of(
        holder.left, [&](const Left& left) { return holds(left, row.arc, row.from_m, row.to_m); });
    if (!row.owner && !is_said)
      problems.add(where + " has no owner, and no reason is given");
    else if (!row.owner)
      return;
    else if (!living.contains(*row.owner))
      problems.add(
          fmt::format("{} is owned by agent {}, which delivered no route", where, *row.owner));
  };
  for (const Delivered& delivered : all) {
    if (&delivered != &all[0] && delivered.tasks == all[0].tasks) continue;
    for (const TaskRow& row : delivered.tasks) check_row(delivered, row);
  }
  return problems;
}

}  // namespace arcbid::checker
