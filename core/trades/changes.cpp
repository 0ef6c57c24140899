// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/changes.hpp"

#include <algorithm>
#include <utility>

namespace arcbid {
namespace {

/// Where a node is in the tours, and whether its stop is entered there.
struct Place {
  std::uint32_t tour, position;
  bool entered;
};

Place place_of(const Tours& tours, Node node) {
  const std::uint32_t lot = node / 2;
  if (lot >= tours.lots()) {
    const auto tour = static_cast<std::uint32_t>(lot - tours.lots());
    return {tour, node % 2 == 0 ? 0 : tours.end(tour), node % 2 == 1};
  }
  const std::uint32_t tour = tours.owner(lot), position = tours.position(lot);
  return {tour, position, tours.at(tour, position) == node};
}

/// Positions `first` to `last`.
struct Span {
  std::uint32_t first, last;
};

/// The lot of `from` and so many behind it, seen from that end of the lot.
std::optional<Span> lots_behind(const Tours& tours, const Place& from, std::uint32_t more) {
  if (from.entered) {
    if (from.position + more >= tours.end(from.tour)) return {};
    return Span{from.position, from.position + more};
  }
  if (from.position <= more) return {};
  return Span{from.position - more, from.position};
}

void put(Recipe& recipe, std::uint32_t tour, std::uint32_t first, std::uint32_t last,
         bool reversed = false) {
  if (first <= last) recipe.add({tour, first, last, reversed});
}

Change priced(const Tours& tours, Change change) {
  change.length_a_m = tours.length_m(change.tour_a);
  if (change.b != Change::none) change.length_b_m = tours.length_m(change.tour_b);
  return change;
}

/// In one tour: [x] goes between `gap` and `gap + 1`.
std::optional<Change> move_within(const Tours& tours, std::uint32_t tour, Span x, std::uint32_t gap,
                                  bool reversed) {
  if (gap + 1 >= x.first && gap <= x.last) return {};
  Change change;
  change.a = tour;
  const TourPart moved{tour, x.first, x.last, reversed};
  put(change.tour_a, tour, 0, std::min(gap, x.first - 1));
  if (gap < x.first) {
    change.tour_a.add(moved);
    put(change.tour_a, tour, gap + 1, x.first - 1);
    put(change.tour_a, tour, x.last + 1, tours.end(tour));
  } else {
    put(change.tour_a, tour, x.last + 1, gap);
    change.tour_a.add(moved);
    put(change.tour_a, tour, gap + 1, tours.end(tour));
  }
  return priced(tours, change);
}

/// In one tour: two spans change places.
std::optional<Change> swap_within(const Tours& tours, std::uint32_t tour, Span x, bool x_reversed,
                                  Span y, bool y_reversed) {
  if (y.first <= x.last && x.first <= y.last) return {};
  if (y.first < x.first) {
    std::swap(x, y);
    std::swap(x_reversed, y_reversed);
  }
  Change change;
  change.a = tour;
  put(change.tour_a, tour, 0, x.first - 1);
  change.tour_a.add({tour, y.first, y.last, y_reversed});
  put(change.tour_a, tour, x.last + 1, y.first - 1);
  change.tour_a.add({tour, x.first, x.last, x_reversed});
  put(change.tour_a, tour, y.last + 1, tours.end(tour));
  return priced(tours, change);
}

/// Of two tours, cut beside these places: what is flown before and after each cut.
Change cross_tours(const Tours& tours, const Place& p, const Place& q) {
  Change change;
  change.a = p.tour;
  change.b = q.tour;
  const std::uint32_t end_a = tours.end(p.tour), end_b = tours.end(q.tour);
  const std::uint32_t head_a = p.entered ? p.position - 1 : p.position;
  const std::uint32_t head_b = q.entered ? q.position - 1 : q.position;
  put(change.tour_a, p.tour, 0, head_a);
  if (p.entered != q.entered) {
    // What comes before the one cut joins what comes after the other.
    put(change.tour_a, q.tour, head_b + 1, end_b - 1);
    put(change.tour_b, q.tour, 0, head_b);
    put(change.tour_b, p.tour, head_a + 1, end_a - 1);
    put(change.tour_b, q.tour, end_b, end_b);
  } else {
    // The two heads make one tour, the two tails the other.
    put(change.tour_a, q.tour, 1, head_b, true);
    put(change.tour_b, q.tour, 0, 0);
    put(change.tour_b, p.tour, head_a + 1, end_a - 1, true);
    put(change.tour_b, q.tour, head_b + 1, end_b);
  }
  put(change.tour_a, p.tour, end_a, end_a);
  return priced(tours, change);
}

}  // namespace

std::optional<Change> move_lots(const Tours& tours, const Wish& wish, std::uint32_t more) {
  const Place from = place_of(tours, wish.one), to = place_of(tours, wish.other);
  const auto x = lots_behind(tours, from, more);
  if (!x) return {};
  const std::uint32_t gap = to.entered ? to.position - 1 : to.position;
  const bool reversed = from.entered == to.entered;
  if (from.tour == to.tour) return move_within(tours, from.tour, *x, gap, reversed);
  Change change;
  change.a = from.tour;
  change.b = to.tour;
  put(change.tour_a, from.tour, 0, x->first - 1);
  put(change.tour_a, from.tour, x->last + 1, tours.end(from.tour));
  put(change.tour_b, to.tour, 0, gap);
  change.tour_b.add({from.tour, x->first, x->last, reversed});
  put(change.tour_b, to.tour, gap + 1, tours.end(to.tour));
  return priced(tours, change);
}

std::optional<Change> swap_lots(const Tours& tours, const Wish& wish, std::uint32_t more,
                                std::uint32_t more_back, bool reversed) {
  const Place from = place_of(tours, wish.one), to = place_of(tours, wish.other);
  const auto x = lots_behind(tours, from, more);
  const bool at_home = to.entered ? to.position == 1 : to.position + 1 == tours.end(to.tour);
  if (!x || at_home) return {};
  const Place next{to.tour, to.entered ? to.position - 1 : to.position + 1, !to.entered};
  const auto y = lots_behind(tours, next, more_back);
  if (!y) return {};
  const bool x_reversed = from.entered == to.entered;
  if (from.tour == to.tour) return swap_within(tours, from.tour, *x, x_reversed, *y, reversed);
  Change change;
  change.a = from.tour;
  change.b = to.tour;
  put(change.tour_a, from.tour, 0, x->first - 1);
  change.tour_a.add({to.tour, y->first, y->last, reversed});
  put(change.tour_a, from.tour, x->last + 1, tours.end(from.tour));
  put(change.tour_b, to.tour, 0, y->first - 1);
  change.tour_b.add({from.tour, x->first, x->last, x_reversed});
  put(change.tour_b, to.tour, y->last + 1, tours.end(to.tour));
  return priced(tours, change);
}

std::optional<Change> cross(const Tours& tours, const Wish& wish) {
  Place p = place_of(tours, wish.one), q = place_of(tours, wish.other);
  if (p.tour != q.tour) return cross_tours(tours, p, q);
  if (p.entered != q.entered) return {};
  if (q.position < p.position) std::swap(p, q);
  const std::uint32_t first = p.entered ? p.position : p.position + 1;
  const std::uint32_t last = q.entered ? q.position - 1 : q.position;
  if (last <= first || first == 0 || last == tours.end(p.tour)) return {};
  Change change;
  change.a = p.tour;
  put(change.tour_a, p.tour, 0, first - 1);
  change.tour_a.add({p.tour, first, last, true});
  put(change.tour_a, p.tour, last + 1, tours.end(p.tour));
  return priced(tours, change);
}

}  // namespace arcbid
