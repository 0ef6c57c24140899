// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/obstacle_transit.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <future>
#include <thread>
#include <utility>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

bool before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

std::size_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  // Adding zero makes -0 and 0, which are equal, hash alike.
  for (const double x : p)
    h = (std::rotl(h, 23) ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>(h >> 20);
}

}  // namespace

ObstacleTransit::ObstacleTransit(const Airspace& airspace, const std::vector<Arc>& arcs,
                                 std::span<const Vec3> places, unsigned threads,
                                 std::vector<double> table)
    : arcs_(arcs),
      airspace_(airspace),
      grid_(airspace_),
      corridors_(arcs_, airspace_, grid_),
      roadmap_(grid_),
      lengths_m_(std::move(table)) {
  std::vector<Vec3> sorted(places.begin(), places.end());
  std::sort(sorted.begin(), sorted.end(), before);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  for (const Vec3& at : sorted) places_.push_back(make_place(at));
  index_places();
  if (lengths_m_.size() != places_.size() * places_.size())
    fill_table(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()));
}

ObstacleTransit::Place ObstacleTransit::make_place(const Vec3& at) const {
  Place place{at, std::nullopt, {}};
  if (!grid_.free(at)) place.on = corridors_.find(at);
  for (Door& door : corridors_.doors(at, place.on)) {
    auto links = roadmap_.links(door.at());
    place.doors.push_back({std::move(door), std::move(links)});
  }
  return place;
}

void ObstacleTransit::index_places() {
  slots_.assign(std::bit_ceil(4 * places_.size() + 1), Points::unknown);
  for (std::uint32_t n = 0; n < places_.size(); ++n) {
    std::size_t slot = hash(places_[n].at) & (slots_.size() - 1);
    while (slots_[slot] != Points::unknown) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = n;
  }
}

std::uint32_t ObstacleTransit::place(const Vec3& point) const {
  std::size_t slot = hash(point) & (slots_.size() - 1);
  for (; slots_[slot] != Points::unknown; slot = (slot + 1) & (slots_.size() - 1))
    if (places_[slots_[slot]].at == point) return slots_[slot];
  return Points::unknown;
}

/// `from` comes before `to`. The search has started there.
std::vector<Vec3> ObstacleTransit::leg(Search& search, const Place& from, const Place& to) const {
  auto way = search.way(to.doors).value_or(std::vector<Vec3>{from.at, to.at});
  if (!from.on || !to.on || from.on->arc != to.on->arc) return way;
  // Two places in the same stretch of an arc that is in no free cell.
  auto along = corridors_.along(*from.on, from.at, *to.on, to.at);
  const bool cut_off = from.doors.empty() || to.doors.empty();
  return cut_off || way_length_m(along) <= way_length_m(way) ? along : way;
}

void ObstacleTransit::fill_table(unsigned threads) {
  const std::size_t n = places_.size();
  lengths_m_.assign(n * n, 0);
  std::atomic<std::uint32_t> next = 0;
  std::vector<std::uint32_t> last_linked(roadmap_.size(), 0);
  for (std::uint32_t a = 0; a < n; ++a)
    for (const LinkedDoor& door : places_[a].doors)
      for (const Roadmap::Link& link : door.links) last_linked[link.node] = a + 1;
  const auto fill_rows = [&] {
    Search search(grid_, roadmap_);
    search.expect(last_linked);
    for (std::uint32_t a = next++; a < n; a = next++) {
      search.start(places_[a].doors, a);
      for (std::size_t b = a + 1; b < n; ++b)
        lengths_m_[a * n + b] = lengths_m_[b * n + a] =
            way_length_m(leg(search, places_[a], places_[b]));
    }
  };
  // What a thread throws (memory runs out) is thrown on by get().
  std::vector<std::future<void>> others;
  for (unsigned t = 1; t < threads; ++t)
    others.push_back(std::async(std::launch::async, fill_rows));
  fill_rows();
  for (std::future<void>& other : others) other.get();
}

double ObstacleTransit::length_m(const Vec3& from, const Vec3& to) const {
  if (from == to) return 0;
  const std::uint32_t a = place(from), b = place(to);
  if (a == Points::unknown || b == Points::unknown) return way_length_m(way(from, to));
  return lengths_m_[a * places_.size() + b];
}

void ObstacleTransit::lengths_m(const Vec3& from, const Points& to, double* out) const {
  const std::uint32_t own = place(from);
  const double* const row =
      own == Points::unknown ? nullptr : lengths_m_.data() + own * places_.size();
  for (std::size_t n = 0; n < to.size(); ++n) {
    const bool known = row != nullptr && to.place[n] != Points::unknown;
    out[n] = known ? row[to.place[n]] : length_m(from, to.at(n));
  }
}

/// As long there as back.
void ObstacleTransit::lengths_m(const Points& from, const Vec3& to, double* out) const {
  lengths_m(to, from, out);
}

std::vector<Vec3> ObstacleTransit::way(const Vec3& from, const Vec3& to) const {
  if (from == to) return {from, to};
  if (before(to, from)) {
    auto back = way(to, from);
    std::reverse(back.begin(), back.end());
    return back;
  }
  const auto place_at = [this](const Vec3& point) {
    const std::uint32_t n = place(point);
    return n == Points::unknown ? make_place(point) : places_[n];
  };
  const Place first = place_at(from), last = place_at(to);
  Search search(grid_, roadmap_);
  search.start(first.doors);
  return leg(search, first, last);
}

std::vector<Vec3> ObstacleTransit::closed_in() const {
  std::vector<Vec3> out;
  for (const Place& place : places_)
    if (place.doors.empty()) out.push_back(place.at);
  return out;
}

}  // namespace arcbid
