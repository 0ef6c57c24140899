// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/picture/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

constexpr double kWidth = 1000, kMargin = 40;
// Okabe and Ito (2008): told apart by every kind of colour vision.
constexpr std::array kColours{"#0072B2", "#E69F00", "#009E73", "#CC79A7",
                              "#56B4E9", "#D55E00", "#000000", "#F0E442"};

struct Point {
  double x, y;
};

struct Line {
  std::vector<Point> points;
  std::size_t agent;
  bool transit;
};

/// Isometric: x to the right and down, y to the right and up, z up.
Point project(const json& waypoint) {
  const double x = waypoint.at(0), y = waypoint.at(1), z = waypoint.at(2);
  return {0.866 * x + 0.5 * y, 0.35 * x - 0.5 * y - z};
}

json read(const std::filesystem::path& file) {
  std::ifstream in(file);
  json content = json::parse(in, nullptr, false);
  if (content.is_discarded())
    throw InputError(fmt::format("{}: is not a file of a run directory", file.string()));
  return content;
}

std::vector<Line> lines_of(const std::filesystem::path& run, const json& fleet) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    const auto file =
        run / "routes" / fmt::format("agent_{}.json", fleet[i].at("agent").get<int>());
    if (!std::filesystem::exists(file)) continue;  // died on the way
    const json delivered = read(file);
    for (const json& leg : delivered.at("route").at("legs")) {
      Line line{{}, i, leg.at("kind") == "transit"};
      for (const json& waypoint : leg.at("waypoints")) line.points.push_back(project(waypoint));
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

/// From projected metres to the sheet.
class Sheet {
 public:
  Sheet(const std::vector<Line>& lines, const std::vector<Point>& homes) {
    const auto cover = [this](const Point& p) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    };
    for (const Line& line : lines) std::for_each(line.points.begin(), line.points.end(), cover);
    std::for_each(homes.begin(), homes.end(), cover);
    scale_ = (kWidth - 2 * kMargin) / std::max(high_.x - low_.x, 1.0);
  }
  Point on(const Point& p) const {
    return {kMargin + (p.x - low_.x) * scale_, kMargin + (p.y - low_.y) * scale_};
  }
  double height() const { return 2 * kMargin + (high_.y - low_.y) * scale_; }

 private:
  Point low_{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high_{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  double scale_ = 1;
};

std::string svg_of(const Line& line, const Sheet& sheet) {
  std::string points;
  for (const Point& p : line.points)
    points += fmt::format("{:.1f},{:.1f} ", sheet.on(p).x, sheet.on(p).y);
  return fmt::format("<polyline points=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", points,
                     kColours[line.agent % kColours.size()], line.transit ? 0.8 : 2.2,
                     line.transit ? " stroke-dasharray=\"3 3\"" : "");
}

std::string draw(const std::filesystem::path& run) {
  const json arcs = read(run / "arcs.json");
  const json& fleet = arcs.at("fleet");
  const std::vector<Line> lines = lines_of(run, fleet);
  std::vector<Point> homes;
  for (const json& uav : fleet) homes.push_back(project(uav.at("home_m")));
  const Sheet sheet(lines, homes);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" fill=\"none\" "
      "stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      kWidth, sheet.height());
  for (const bool transit : {true, false})
    for (const Line& line : lines)
      if (line.transit == transit) svg += svg_of(line, sheet);
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const Point at = sheet.on(homes[i]);
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"16\" fill=\"#333333\">{}</text>\n",
        at.x, at.y, kColours[i % kColours.size()], at.x + 9, at.y + 6,
        fleet[i].at("agent").get<int>());
  }
  return svg + "</svg>\n";
}

}  // namespace

std::string draw_routes(const std::filesystem::path& run) {
  try {
    return draw(run);
  } catch (const json::exception& error) {
    throw InputError(
        fmt::format("{}: is not a whole run directory: {}", run.string(), error.what()));
  }
}

}  // namespace arcbid
