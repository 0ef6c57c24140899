// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace arcbid::checker {

/// Lengths that differ by no more are the same, metres.
constexpr double kTolerance_m = 1e-3;

struct Point {
  double x = 0, y = 0, z = 0;
};

/// A place and the direction of the sensor there.
struct PathPoint {
  Point position_m;
  Point look;
};
using Path = std::vector<PathPoint>;

double distance(const Point& a, const Point& b);
double norm(const Point& p);
double length_m(const Path& path);

/// 1 mm, and one part in 10^9 for sums over long routes.
bool same_length(double a_m, double b_m);

/// Why `flown` is not the stretch of `arc` from from_m to to_m (from_m > to_m: backwards); empty
/// when it is. It has to begin and end at these arc lengths, visit every waypoint of the arc in
/// between, in order and looking the same way, and stay on the arc meanwhile, all within 1 mm.
std::string why_not_the_stretch(const Path& flown, const Path& arc, double from_m, double to_m);

/// "(1.000, 2.000, 3.000)".
std::string text(const Point& p);

}  // namespace arcbid::checker
