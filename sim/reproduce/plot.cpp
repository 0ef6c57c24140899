// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "core/base/error.hpp"
#include "sim/launcher/child.hpp"
#include "sim/reproduce/report.hpp"

namespace arcbid::reproduce {
namespace {

// Okabe and Ito (2008): told apart by every kind of colour vision.
constexpr std::array kColours{"#0072B2", "#E69F00", "#009E73", "#CC79A7",
                              "#56B4E9", "#D55E00", "#000000", "#F0E442"};
constexpr std::array kMarks{7, 5, 9, 13, 11, 15, 4, 6};
constexpr std::size_t kPanelWidth = 560, kPanelHeight = 380, kMapWidth = 1000, kMapHeight = 260;

bool is_map(const Panel& panel) {
  return panel.x_label.empty() && panel.y_label.empty();
}

bool is_empty(const Series& series) {
  return std::ranges::all_of(series.strokes, [](const auto& stroke) { return stroke.empty(); });
}

/// A string of gnuplot's in which nothing has a meaning of its own.
std::string literal(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

std::string data_block(const std::string& name, const Series& series) {
  std::string out = fmt::format("{} << EOD\n", name);
  for (const auto& stroke : series.strokes) {
    for (const PlotPoint& point : stroke) out += fmt::format("{:.6g} {:.6g}\n", point.x, point.y);
    out += "\n";
  }
  return out + "EOD\n";
}

std::string style_of(const Series& series, bool on_map) {
  const auto colour = static_cast<std::size_t>(series.colour);
  const std::string lines = fmt::format(" lw {}", on_map ? 0.8 : 1.6);
  const std::string dots =
      fmt::format(" pt {} ps {}", kMarks[on_map ? 0 : colour % kMarks.size()], on_map ? 0.3 : 0.6);
  return fmt::format("with {} lc rgb \"{}\"{}{}",
                     series.lines && series.dots ? "linespoints"
                     : series.lines              ? "lines"
                                                 : "points",
                     kColours[colour % kColours.size()], series.lines ? lines : "",
                     series.dots ? dots : "");
}

std::string panel_script(const Panel& panel, std::size_t number) {
  std::string blocks, plots;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const Series& series = panel.series[s];
    if (is_empty(series)) continue;
    const std::string name = fmt::format("$panel{}_{}", number, s);
    blocks += data_block(name, series);
    plots += fmt::format("{}{} using 1:2 {} {}", plots.empty() ? "plot " : ", \\\n     ", name,
                         style_of(series, is_map(panel)),
                         series.name.empty() ? "notitle" : "title " + literal(series.name));
  }
  if (plots.empty()) return "set multiplot next\n";
  const std::string axes =
      is_map(panel) ? "unset border\nunset tics\nunset xlabel\nunset ylabel\nset size ratio -1\n"
                      "set key outside right center\n"
                    : fmt::format(
                          "set xlabel {}\nset ylabel {}\nset key outside bottom center "
                          "horizontal\nset yrange [0:*]\n",
                          literal(panel.x_label), literal(panel.y_label));
  return fmt::format("{}set title {}\n{}{}\n", blocks, literal(panel.title), axes, plots);
}

}  // namespace

std::string gnuplot_script(const Picture& picture) {
  const std::size_t columns = std::max<std::size_t>(1, picture.panels_in_a_row);
  const std::size_t rows = (picture.panels.size() + columns - 1) / columns;
  const bool map = !picture.panels.empty() && is_map(picture.panels.front());
  std::string out = fmt::format(
      "set terminal svg size {},{} font \"sans,13\" background \"white\" noenhanced\n"
      "set output {}\nset multiplot layout {},{}\n",
      columns * (map ? kMapWidth : kPanelWidth), rows * (map ? kMapHeight : kPanelHeight),
      literal(picture.name + ".svg"), rows, columns);
  for (std::size_t p = 0; p < picture.panels.size(); ++p) out += panel_script(picture.panels[p], p);
  return out + "unset multiplot\n";
}

bool draw(const std::filesystem::path& folder, const std::string& script) {
  constexpr int not_found = 127;  // says env
  Child gnuplot("gnuplot", {"/usr/bin/env", "-C", folder.string(), "gnuplot", script});
  while (gnuplot.running()) {
    gnuplot.read_lines();
    gnuplot.poll();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (gnuplot.exit_code() == not_found) return false;
  if (gnuplot.exit_code() != 0)
    throw RunError(fmt::format("{}: gnuplot could not draw it", (folder / script).string()));
  return true;
}

}  // namespace arcbid::reproduce
