// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/trim.hpp"

#include <algorithm>
#include <numeric>

#include "core/coverage/parallel.hpp"

namespace arcbid {

namespace {

constexpr double kStation_m = 1.0;
/// Over all stations; together the passes take each once.
struct Pass {
  std::size_t first, stride;
};
constexpr Pass kPasses[] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};

/// Keeps count of how many stations see each sample.
class Trimmer {
 public:
  Trimmer(const std::vector<SeenArc>& arcs, std::size_t samples) : seen_by_(samples) {
    for (const SeenArc& arc : arcs)
      for (const Seen& seen : arc.seen)
        for (const std::uint32_t s : seen) ++seen_by_[s];
  }

  /// Samples that only this arc sees, for each metre of it.
  double use(const SeenArc& arc) {
    change(arc, -1);
    std::size_t only = 0;
    for (const Seen& seen : arc.seen)
      only += static_cast<std::size_t>(std::count_if(
          seen.begin(), seen.end(), [&](std::uint32_t s) { return seen_by_[s] == 0; }));
    change(arc, 1);
    return static_cast<double>(only) / std::max(arc.at_m.back(), 1e-9);
  }

  bool dropped(const SeenArc& arc) {
    change(arc, -1);
    for (const Seen& seen : arc.seen)
      for (const std::uint32_t s : seen)
        if (seen_by_[s] == 0) {
          change(arc, 1);
          return false;
        }
    return true;
  }

  /// Takes a station away if all that it sees is seen from others too.
  bool taken(const Seen& seen) {
    for (const std::uint32_t s : seen)
      if (seen_by_[s] < 2) return false;
    for (const std::uint32_t s : seen) --seen_by_[s];
    return true;
  }
  void give_back(const Seen& seen) {
    for (const std::uint32_t s : seen) ++seen_by_[s];
  }

 private:
  void change(const SeenArc& arc, int by) {
    for (const Seen& seen : arc.seen)
      for (const std::uint32_t s : seen) seen_by_[s] += by;
  }
  std::vector<int> seen_by_;
};

using Stretch = std::pair<std::size_t, std::size_t>;  // first and last station, both kept

/// Cuts the ends, and pulls them back out until what is left is long enough.
Stretch without_ends(const SeenArc& arc, Trimmer& trimmer, double least_m) {
  std::size_t first = 0, last = arc.seen.size() - 1;
  const auto long_enough = [&](std::size_t a, std::size_t b) {
    return arc.at_m[b] - arc.at_m[a] >= least_m;
  };
  while (first < last && long_enough(first + 1, last) && trimmer.taken(arc.seen[first])) ++first;
  while (first < last && long_enough(first, last - 1) && trimmer.taken(arc.seen[last])) --last;
  return {first, last};
}

/// The stretches that are left when long useless middles are gone.
std::vector<Stretch> without_middles(const SeenArc& arc, const Stretch& whole, Trimmer& trimmer,
                                     const TrimLimits& limits) {
  std::vector<Stretch> kept;
  std::size_t first = whole.first, k = first + 1;
  const double end_m = arc.at_m[whole.second];
  while (k < whole.second) {
    std::size_t to = k;
    while (to < whole.second && trimmer.taken(arc.seen[to])) ++to;
    const std::size_t before = k - 1;
    const bool worth = arc.at_m[to] - arc.at_m[before] >= limits.middle_m &&
                       arc.at_m[before] - arc.at_m[first] >= limits.least_m &&
                       end_m - arc.at_m[to] >= limits.least_m;
    if (worth) {
      kept.emplace_back(first, before);
      first = to;
    } else {
      for (std::size_t s = k; s < to; ++s) trimmer.give_back(arc.seen[s]);
    }
    k = std::max(to, k) + 1;
  }
  kept.emplace_back(first, whole.second);
  return kept;
}

}  // namespace

std::vector<bool> seen_along(const Seer& seer, const std::vector<Arc>& arcs,
                             std::vector<Wanted> wanted, unsigned threads) {
  std::vector<Waypoint> places;
  for (const Arc& arc : arcs) {
    const std::vector<Waypoint> own = stations(arc.waypoints, kStation_m);
    places.insert(places.end(), own.begin(), own.end());
  }
  std::vector<bool> covered(wanted.size());
  // Few stations, far apart, see most.
  for (const Pass& pass : kPasses) {
    const std::size_t count = (places.size() + pass.stride - 1 - pass.first) / pass.stride;
    std::vector<Seen> all(count);
    for_chunks(count, 8, threads, [&](std::size_t from, std::size_t to) {
      for (std::size_t k = from; k < to; ++k)
        all[k] = seer.seen(places[pass.first + k * pass.stride], wanted);
    });
    for (const Seen& seen : all)
      for (const std::uint32_t s : seen) {
        covered[s] = true;
        wanted[s] = Wanted::no;
      }
  }
  return covered;
}

std::vector<SeenArc> look_along(const Seer& seer, std::vector<Arc> arcs,
                                const std::vector<Wanted>& wanted, unsigned threads) {
  std::vector<SeenArc> result;
  std::vector<Waypoint> places;
  for (Arc& arc : arcs) {
    const std::vector<Waypoint> own = stations(arc.waypoints, kStation_m);
    SeenArc seen{std::move(arc), {0.0}, std::vector<Seen>(own.size())};
    for (std::size_t k = 1; k < own.size(); ++k)
      seen.at_m.push_back(seen.at_m.back() + (own[k].position_m - own[k - 1].position_m).norm());
    places.insert(places.end(), own.begin(), own.end());
    result.push_back(std::move(seen));
  }
  std::vector<Seen> all(places.size());
  for_chunks(places.size(), 8, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) all[k] = seer.seen(places[k], wanted);
  });
  auto next = all.begin();
  for (SeenArc& arc : result)
    for (Seen& seen : arc.seen) seen = std::move(*next++);
  return result;
}

std::vector<Arc> trimmed(std::vector<SeenArc> arcs, std::size_t samples, const TrimLimits& limits) {
  Trimmer trimmer(arcs, samples);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t a = 0; a < arcs.size(); ++a) order.emplace_back(trimmer.use(arcs[a]), a);
  std::sort(order.begin(), order.end());
  std::vector<bool> gone(arcs.size());
  for (const auto& [use, a] : order) gone[a] = trimmer.dropped(arcs[a]);
  std::vector<std::vector<Stretch>> kept(arcs.size());
  for (const auto& [use, a] : order) {
    if (gone[a]) continue;
    const Stretch whole = without_ends(arcs[a], trimmer, limits.least_m);
    kept[a] = without_middles(arcs[a], whole, trimmer, limits);
  }
  std::vector<Arc> result;
  for (std::size_t a = 0; a < arcs.size(); ++a)
    for (const auto& [first, last] : kept[a]) {
      Arc arc = arcs[a].arc;
      if (first > 0 || last + 1 < arcs[a].seen.size())
        arc.waypoints = part(arc.waypoints, arcs[a].at_m[first], arcs[a].at_m[last]);
      if (arc.waypoints.size() >= 2) result.push_back(std::move(arc));
    }
  return result;
}

}  // namespace arcbid
