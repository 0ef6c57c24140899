// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/structure/track.hpp"

namespace arcbid {

namespace {

constexpr double kStep_m = 1.0;        // between the points that are pushed one by one
constexpr int kHalvings = 3;           // of that step where they have parted
constexpr double kTolerance_m = 0.05;  // by which a pushed stretch may be smoothed

double off_segment_m(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length2 = way.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - from).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (p - from - share * way).norm();
}

bool may_skip(const std::vector<Vec3>& line, std::size_t from, std::size_t to, double tolerance_m) {
  for (std::size_t i = from + 1; i < to; ++i)
    if (off_segment_m(line[i], line[from], line[to]) > tolerance_m) return false;
  return true;
}

/// Greedy: from each point as far as `legal` allows the chord.
template <class Legal>
std::vector<Vec3> chords(const std::vector<Vec3>& line, Legal legal) {
  std::vector<Vec3> kept{line.front()};
  for (std::size_t from = 0; from + 1 < line.size();) {
    std::size_t to = from + 1;
    while (to + 1 < line.size() && legal(from, to + 1)) ++to;
    kept.push_back(line[to]);
    from = to;
  }
  return kept;
}

std::vector<Vec3> as_line(const Track& track) {
  std::vector<Vec3> line = track.points;
  if (track.closed) line.push_back(line.front());
  return line;
}

Track as_track(std::vector<Vec3> line, bool closed) {
  if (closed) line.pop_back();
  return {std::move(line), closed};
}

bool all_clear(const Track& track, const Clearance& clearance) {
  const std::vector<Vec3> line = as_line(track);
  for (std::size_t i = 1; i < line.size(); ++i)
    if (!clearance.clears(line[i - 1], line[i])) return false;
  return true;
}

/// Appends `next` to a stretch, by way of pushed points half-way where the chord is too near.
/// False, and the stretch unchanged: there is no way.
bool joined(std::vector<Vec3>& run, const Vec3& next, const Clearance& clearance, double push_m,
            int halvings) {
  if ((next - run.back()).norm() < 1e-6) return true;
  if (clearance.clears(run.back(), next)) {
    run.push_back(next);
    return true;
  }
  if (halvings == 0) return false;
  const auto half_way = clearance.pushed_clear(0.5 * (run.back() + next), push_m);
  const std::size_t size = run.size();
  if (half_way && joined(run, *half_way, clearance, push_m, halvings - 1) &&
      joined(run, next, clearance, push_m, halvings - 1))
    return true;
  run.resize(size);
  return false;
}

/// The pushed points in stretches whose every segment may be flown.
std::vector<std::vector<Vec3>> stretches(const std::vector<Vec3>& line, const Clearance& clearance,
                                         double push_m) {
  std::vector<std::vector<Vec3>> runs(1);
  for (const Vec3& p : line) {
    const std::optional<Vec3> pushed = clearance.pushed_clear(p, push_m);
    std::vector<Vec3>& run = runs.back();
    if (!pushed) {
      if (!run.empty()) runs.emplace_back();
      continue;
    }
    if (run.empty())
      run.push_back(*pushed);
    else if (!joined(run, *pushed, clearance, push_m, kHalvings))
      runs.push_back({*pushed});
  }
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

/// Of a closed line: whether the last stretch goes on as the first, over the line's seam.
bool wraps(const std::vector<std::vector<Vec3>>& runs) {
  return runs.size() > 1 && (runs.front().front() - runs.back().back()).norm() < 1e-6;
}

}  // namespace

double length_m(const Track& track) {
  double sum_m = 0;
  const std::vector<Vec3> line = as_line(track);
  for (std::size_t i = 1; i < line.size(); ++i) sum_m += (line[i] - line[i - 1]).norm();
  return sum_m;
}

Track simplified(const Track& track, double tolerance_m) {
  const std::vector<Vec3> line = as_line(track);
  const auto legal = [&](std::size_t from, std::size_t to) {
    // Never the whole ring in one chord.
    return !(track.closed && from == 0 && to + 1 == line.size()) &&
           may_skip(line, from, to, tolerance_m);
  };
  return as_track(chords(line, legal), track.closed);
}

Track densified(const Track& track, double spacing_m) {
  const std::vector<Vec3> line = as_line(track);
  std::vector<Vec3> dense{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 &from = line[i - 1], &to = line[i];
    // A hair less than spacing_m, so that rounding cannot make a piece longer than it.
    const double n = std::ceil((to - from).norm() / spacing_m - 1e-9);
    for (double k = 1; k < n; ++k) dense.push_back(from + k / n * (to - from));
    dense.push_back(to);
  }
  return as_track(std::move(dense), track.closed);
}

std::vector<Track> kept_clear(const Track& track, const Clearance& clearance, const Repair& repair,
                              double& lost_m) {
  if (all_clear(track, clearance)) return {track};

  const double step_m = std::min(kStep_m, repair.spacing_m);
  auto runs = stretches(as_line(densified(track, step_m)), clearance, repair.push_m);
  if (track.closed && wraps(runs)) {
    runs.back().insert(runs.back().end(), runs.front().begin() + 1, runs.front().end());
    runs.erase(runs.begin());
  }
  std::vector<Track> kept;
  double kept_m = 0;
  for (const std::vector<Vec3>& run : runs) {
    const bool closed =
        track.closed && runs.size() == 1 && run.size() > 3 && run.front() == run.back();
    const std::vector<Vec3> line = chords(run, [&](std::size_t from, std::size_t to) {
      return !(closed && from == 0 && to + 1 == run.size()) &&
             (run[to] - run[from]).norm() <= repair.spacing_m &&
             may_skip(run, from, to, kTolerance_m) && clearance.clears(run[from], run[to]);
    });
    Track part = as_track(line, closed);
    if (line.size() < 2 || length_m(part) < repair.least_m) continue;
    kept_m += length_m(part);
    kept.push_back(densified(part, repair.spacing_m));  // pushing can part neighbours
  }
  lost_m += std::max(0.0, length_m(track) - kept_m);
  return kept;
}

}  // namespace arcbid
