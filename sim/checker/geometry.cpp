// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/checker/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace arcbid::checker {

namespace {

constexpr double kLookTolerance = 1e-6;

Point minus(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Point between(const Point& a, const Point& b, double fraction) {
  return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y), a.z + fraction * (b.z - a.z)};
}

/// Where on the segment the point nearest to `p` lies, 0 at `a`, 1 at `b`.
double nearest_fraction(const Point& a, const Point& b, const Point& p) {
  const Point d = minus(b, a), e = minus(p, a);
  const double squared = d.x * d.x + d.y * d.y + d.z * d.z;
  if (squared == 0) return 0;
  return std::clamp((d.x * e.x + d.y * e.y + d.z * e.z) / squared, 0.0, 1.0);
}

/// A point that has to be visited. Where the arc is cut inside a segment the look is not given.
struct Station {
  Point position_m;
  std::optional<Point> look;
};

Station cut(const PathPoint& a, const PathPoint& b, double distance_m) {
  const double segment_m = distance(a.position_m, b.position_m);
  if (distance_m <= 0 || segment_m == 0) return {a.position_m, a.look};
  if (distance_m >= segment_m) return {b.position_m, b.look};
  return {between(a.position_m, b.position_m, distance_m / segment_m), {}};
}

/// What flying `arc` from low_m to high_m has to visit, in order.
std::vector<Station> stations(const Path& arc, double low_m, double high_m) {
  std::vector<Station> result;
  double start_m = 0;
  for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
    const PathPoint &a = arc[i], &b = arc[i + 1];
    const double end_m = start_m + distance(a.position_m, b.position_m);
    const bool last = i + 2 == arc.size();
    if (result.empty() && (low_m < end_m || last)) result.push_back(cut(a, b, low_m - start_m));
    if (!result.empty() && (high_m <= end_m || last)) {
      result.push_back(cut(a, b, high_m - start_m));
      return result;
    }
    if (!result.empty()) result.push_back({b.position_m, b.look});
    start_m = end_m;
  }
  return result;
}

/// Follows a flown path from station to station.
class Follower {
 public:
  Follower(const Path& flown, const std::vector<Station>& expected)
      : flown_(flown), expected_(expected) {}

  std::string why_not_followed() {
    for (std::size_t i = 0; i < flown_.size(); ++i) {
      const std::size_t before = next_;
      for (; reaches_next(i); ++next_)
        if (looks_elsewhere(i))
          return fmt::format("waypoint {} looks along {}, the arc there along {}", i,
                             text(flown_[i].look), text(*expected_[next_].look));
      if (next_ != before) {
        reached_ = 0;
      } else if (std::string reason = why_not_on_the_way(i); !reason.empty()) {
        return reason;
      }
    }
    if (next_ == expected_.size()) return {};
    return fmt::format("it does not reach {}", text(expected_[next_].position_m));
  }

 private:
  double to_station(std::size_t waypoint, std::size_t station) const {
    return distance(flown_[waypoint].position_m, expected_[station].position_m);
  }

  /// A station belongs to the nearer of two waypoints that are both close enough.
  bool reaches_next(std::size_t i) const {
    if (next_ == expected_.size() || to_station(i, next_) > kTolerance_m) return false;
    const bool nearer_ahead =
        i + 1 < flown_.size() && to_station(i + 1, next_) < to_station(i, next_);
    return next_ == 0 || !nearer_ahead;
  }

  bool looks_elsewhere(std::size_t i) const {
    const std::optional<Point>& look = expected_[next_].look;
    return look && norm(minus(*look, flown_[i].look)) > kLookTolerance;
  }

  /// For a waypoint between two stations: on the segment, and not back along it.
  std::string why_not_on_the_way(std::size_t i) {
    const Point& here = flown_[i].position_m;
    if (next_ == 0)
      return fmt::format("it begins at {}, {:.4f} m from where it should", text(here),
                         to_station(i, 0));
    if (next_ == expected_.size())
      return to_station(i, next_ - 1) <= kTolerance_m
                 ? ""
                 : fmt::format("waypoint {} at {} is past its end", i, text(here));
    const Point &a = expected_[next_ - 1].position_m, &b = expected_[next_].position_m;
    const double fraction = nearest_fraction(a, b, here);
    const double off_m = distance(between(a, b, fraction), here);
    if (off_m > kTolerance_m)
      return fmt::format("waypoint {} at {} is {:.4f} m off the arc on the way to {}", i,
                         text(here), off_m, text(b));
    if ((reached_ - fraction) * distance(a, b) > kTolerance_m)
      return fmt::format("waypoint {} at {} goes back along the arc", i, text(here));
    reached_ = std::max(reached_, fraction);
    return {};
  }

  const Path& flown_;
  const std::vector<Station>& expected_;
  std::size_t next_ = 0;  ///< the station to reach
  double reached_ = 0;    ///< how far along the segment that leads there
};

}  // namespace

double norm(const Point& p) {
  return std::hypot(p.x, p.y, p.z);
}

double distance(const Point& a, const Point& b) {
  return norm(minus(a, b));
}

double length_m(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += distance(path[i - 1].position_m, path[i].position_m);
  return sum;
}

bool same_length(double a_m, double b_m) {
  return std::abs(a_m - b_m) <= kTolerance_m + 1e-9 * std::abs(b_m);
}

std::string why_not_the_stretch(const Path& flown, const Path& arc, double from_m, double to_m) {
  std::vector<Station> expected = stations(arc, std::min(from_m, to_m), std::max(from_m, to_m));
  if (from_m > to_m) std::ranges::reverse(expected);
  std::string reason = Follower(flown, expected).why_not_followed();
  const double flown_m = length_m(flown), stretch_m = std::abs(to_m - from_m);
  if (reason.empty() && !same_length(flown_m, stretch_m))
    reason =
        fmt::format("its waypoints are {:.4f} m long, the stretch {:.4f} m", flown_m, stretch_m);
  return reason;
}

std::string text(const Point& p) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", p.x, p.y, p.z);
}

}  // namespace arcbid::checker
