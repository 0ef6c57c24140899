// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/reproduce/experiment.hpp"

namespace arcbid::reproduce {

/// The experiments on a bridge, and with budgets, that take seconds.
inline Settings small_settings() {
  Settings settings;
  settings.repeats = 2;
  settings.bridge = {.length_m = 60, .width_m = 12, .deck_height_m = 12, .piers = 1};
  settings.effort = 0.01;
  return settings;
}

/// The place of a column, by its name.
inline std::size_t column(const Table& table, std::string_view name) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].name == name) return c;
  return table.columns.size();
}

inline double number(const Table& table, std::size_t row, std::string_view name) {
  return std::get<double>(table.rows.at(row).at(column(table, name)));
}

inline std::string text(const Table& table, std::size_t row, std::string_view name) {
  return std::get<std::string>(table.rows.at(row).at(column(table, name)));
}

/// All but the seconds.
inline std::vector<std::vector<Cell>> without_seconds(const Table& table) {
  auto rows = table.rows;
  for (auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      if (table.columns[c].name.ends_with("cpu_s")) row[c] = Cell();
  return rows;
}

}  // namespace arcbid::reproduce
