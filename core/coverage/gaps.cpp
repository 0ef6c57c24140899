// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/gaps.hpp"

#include <algorithm>
#include <queue>

#include "core/coverage/parallel.hpp"

namespace arcbid {

namespace {

constexpr int kLattice = 4;  // cells between lattice positions

/// Lattice positions from which some of the samples may be in range, in the grid's order.
std::vector<Vec3> lattice_near(const Seer& seer, const Flyable& flyable, const Seen& samples) {
  const Vec3 reach = Vec3::Constant(seer.optics(Wanted::narrow).range_m());
  std::vector<Flyable::Cell> cells;
  for (const std::uint32_t s : samples) {
    const Vec3 p = seer.samples().points[s].cast<double>();
    Flyable::Cell low = flyable.cell_of(p - reach);
    for (int& i : low) i = (std::max(i, 0) + kLattice - 1) / kLattice * kLattice;
    const Flyable::Cell high = flyable.cell_of(p + reach);
    Flyable::Cell c;
    for (c[2] = low[2]; c[2] <= high[2]; c[2] += kLattice)
      for (c[1] = low[1]; c[1] <= high[1]; c[1] += kLattice)
        for (c[0] = low[0]; c[0] <= high[0]; c[0] += kLattice)
          if (flyable.reached(c) &&
              seer.optics(Wanted::narrow)
                  .in_reach(flyable.centre(c).cast<float>(), seer.samples().points[s],
                            seer.samples().normals[s]))
            cells.push_back(c);
    // Neighbours in the list share most of their cells.
    if (cells.size() > 1'000'000) {
      std::sort(cells.begin(), cells.end());
      cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Vec3> places;
  for (const Flyable::Cell& c : cells) places.push_back(flyable.centre(c));
  return places;
}

Vec3 toward(const Seer& seer, const Vec3& from, const Seen& samples) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t s : samples)
    sum += (seer.samples().points[s].cast<double>() - from).normalized();
  return sum.norm() > 1e-6
             ? Vec3(sum.normalized())
             : (seer.samples().points[samples.front()].cast<double>() - from).normalized();
}

/// The directions of a cube's faces, edges and corners, and that of the samples' middle.
std::vector<Vec3> aims(const Optics& optics, const Vec3& middle) {
  std::vector<Vec3> all{optics.aim(middle)};
  if (optics.all_round()) return all;
  for (int k = 0; k < 27; ++k) {
    const Vec3 d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    if (k != 13) all.push_back(optics.aim(d.normalized()));
  }
  return all;
}

/// All views from each place that see something.
std::vector<View> views_from(const Seer& seer, const std::vector<Vec3>& places,
                             const std::vector<Wanted>& wanted, unsigned threads) {
  std::vector<std::vector<View>> found(places.size());
  for_chunks(places.size(), 16, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      const Seen around = seer.around(places[k], wanted);
      if (around.empty()) continue;
      for (const Vec3& aim : aims(seer.optics(Wanted::narrow), toward(seer, places[k], around))) {
        View view{{places[k], aim}, {}};
        view.seen = seer.in_view(view.waypoint, around, wanted);
        if (!view.seen.empty()) found[k].push_back(std::move(view));
      }
    }
  });
  std::vector<View> views;
  for (std::vector<View>& of_place : found)
    std::move(of_place.begin(), of_place.end(), std::back_inserter(views));
  return views;
}

/// Greedy set cover. Gains only fall, so a view whose gain, reckoned anew, is still the greatest is
/// the best. Chosen samples are no longer wanted.
void choose(const std::vector<View>& views, std::vector<Wanted>& wanted,
            std::vector<Waypoint>& chosen) {
  using Entry = std::pair<std::size_t, std::ptrdiff_t>;  // gain, minus the number: ties go by it
  std::priority_queue<Entry> queue;
  for (std::size_t v = 0; v < views.size(); ++v)
    queue.emplace(views[v].seen.size(), -static_cast<std::ptrdiff_t>(v));
  while (!queue.empty()) {
    const auto [old_gain, number] = queue.top();
    queue.pop();
    const View& view = views[static_cast<std::size_t>(-number)];
    const auto gain = static_cast<std::size_t>(
        std::count_if(view.seen.begin(), view.seen.end(),
                      [&](std::uint32_t s) { return wanted[s] != Wanted::no; }));
    if (gain == 0) continue;
    if (gain < old_gain && !queue.empty() && Entry{gain, number} < queue.top()) {
      queue.emplace(gain, number);
      continue;
    }
    for (const std::uint32_t s : view.seen) wanted[s] = Wanted::no;
    chosen.push_back(view.waypoint);
  }
}

}  // namespace

std::vector<Waypoint> views_of_gap(const Seer& seer, const Flyable& flyable, const Gap& gap,
                                   unsigned threads) {
  std::vector<Wanted> wanted = gap.wanted;
  std::vector<Waypoint> chosen;
  choose(views_from(seer, lattice_near(seer, flyable, gap.samples), wanted, threads), wanted,
         chosen);
  std::vector<View> last;
  for (std::size_t k = 0; k < gap.samples.size(); ++k) {
    if (wanted[gap.samples[k]] == Wanted::no) continue;
    const Vec3& place = gap.witnesses[k].position_m;
    const Vec3 way = seer.samples().points[gap.samples[k]].cast<double>() - place;
    last.push_back({{place, seer.optics(Wanted::narrow).aim(way)}, {}});
  }
  for_chunks(last.size(), 16, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v) last[v].seen = seer.seen(last[v].waypoint, wanted);
  });
  choose(last, wanted, chosen);
  return chosen;
}

}  // namespace arcbid
