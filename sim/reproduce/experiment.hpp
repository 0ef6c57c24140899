// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/structure/parametric.hpp"

namespace arcbid::reproduce {

/// A field of a table; the paper has not all that we measure, and the other way round.
using Cell = std::variant<std::monostate, double, std::string>;

struct Column {
  std::string name;   ///< in CSV files, its unit at the end
  std::string title;  ///< for people
  int digits = 0;     ///< behind the point, for people
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< a cell a column
};

struct PlotPoint {
  double x = 0, y = 0;
};

/// What is drawn in one colour: strokes, or a dot at each of their points, or both.
struct Series {
  std::string name;  ///< empty: not in the key
  std::vector<std::vector<PlotPoint>> strokes;
  bool lines = true, dots = true;
  int colour = 0;
};

struct Panel {
  std::string title, x_label, y_label;  ///< a panel without labels is a map: no axes, one scale
  std::vector<Series> series;
};

struct Picture {
  std::string name;  ///< of its file, without the ending
  std::string caption;
  std::size_t panels_in_a_row = 2;
  std::vector<Panel> panels;
};

/// What became of an experiment of the paper.
struct Finding {
  std::string name;   ///< as on the command line; its table's file
  std::string title;  ///< what the paper shows there
  std::string setting;
  Table table;
  std::vector<Picture> pictures;
  std::vector<std::string> differences;  ///< where we and the paper part, and why: a sentence each
};

/// The paper does not give its own bridge: with these numbers the paper's arcs are nearest in
/// number.
inline constexpr ParametricBridge kBridge{
    .length_m = 460, .width_m = 24, .deck_height_m = 16, .piers = 5};

struct Settings {
  std::uint32_t repeats = 20;
  std::uint64_t seed = 1;
  unsigned jobs = 1;  ///< threads; the results are the same for any number
  std::optional<std::filesystem::path> tsplib;
  ParametricBridge bridge = kBridge;
  double effort = 1;  ///< share of the iterations that solvers of tours are given
  std::function<void(const std::string&)> tell = [](const std::string&) {};  ///< how far it is
};

/// Each is a function of its settings, but for seconds. Throw InputError.
Finding table1(const Settings& settings);
Finding table2(const Settings& settings);
Finding fig5(const Settings& settings);
Finding fig6(const Settings& settings);
Finding fig7(const Settings& settings);
Finding fig8(const Settings& settings);
Finding fig10(const Settings& settings);
Finding fig11(const Settings& settings);

struct Experiment {
  std::string_view name;
  Finding (*run)(const Settings&);
};
inline constexpr std::array<Experiment, 8> kExperiments{{{"table1", table1},
                                                         {"table2", table2},
                                                         {"fig5", fig5},
                                                         {"fig6", fig6},
                                                         {"fig7", fig7},
                                                         {"fig8", fig8},
                                                         {"fig10", fig10},
                                                         {"fig11", fig11}}};

}  // namespace arcbid::reproduce
