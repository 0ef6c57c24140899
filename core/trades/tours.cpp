// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trades/tours.hpp"

#include <algorithm>

namespace arcbid {

namespace {

Load load_of(const Lot& lot) {
  return {lot.tasks, lot.payload == Payload::lidar, lot.payload == Payload::camera};
}

}  // namespace

Load& Load::operator+=(const Load& more) {
  tasks += more.tasks, lidar += more.lidar, camera += more.camera;
  return *this;
}

Load& Load::operator-=(const Load& less) {
  tasks -= less.tasks, lidar -= less.lidar, camera -= less.camera;
  return *this;
}

Tours::Tours(const std::vector<Lot>& lots, const Legs& legs, const Allocation& allocation)
    : legs_(&legs),
      tours_(allocation.size()),
      flown_m_(allocation.size()),
      carried_(allocation.size()),
      owner_(lots.size(), Change::none),
      position_(lots.size()) {
  for (const Lot& lot : lots) {
    lengths_m_.push_back(lot.length_m);
    loads_.push_back(load_of(lot));
  }
  lengths_m_.resize(lots.size() + allocation.size());
  loads_.resize(lots.size() + allocation.size());
  for (std::uint32_t a = 0; a < count(); ++a) {
    const Code home = 2 * (static_cast<Code>(lots.size()) + a);
    tours_[a] = {home};
    for (const LotStop& stop : allocation[a]) tours_[a].push_back(2 * stop.lot + stop.reversed);
    tours_[a].push_back(home);
    renumber(a);
  }
}

double Tours::within_m(const TourPart& s) const {
  const std::vector<double>& flown_m = flown_m_[s.tour];
  return flown_m[s.last] - flown_m[s.first] + lengths_m_[tours_[s.tour][s.first] / 2];
}

double Tours::length_m(const Recipe& recipe) const {
  double sum_m = 0;
  Node left_at = 0;
  for (std::uint32_t k = 0; k < recipe.count; ++k) {
    const TourPart& s = recipe.parts[k];
    const Code first = tours_[s.tour][s.first], last = tours_[s.tour][s.last];
    if (k > 0) sum_m += legs_->length_m(left_at, s.reversed ? last ^ 1 : first);
    left_at = s.reversed ? first : last ^ 1;
    sum_m += within_m(s);
  }
  return sum_m;
}

Load Tours::load(const Recipe& recipe) const {
  Load sum;
  for (std::uint32_t k = 0; k < recipe.count; ++k) {
    const TourPart& s = recipe.parts[k];
    sum += carried_[s.tour][s.last];
    sum -= carried_[s.tour][s.first];
    sum += loads_[tours_[s.tour][s.first] / 2];
  }
  return sum;
}

void Tours::make(const Recipe& recipe, std::vector<Code>& tour) const {
  tour.clear();
  for (std::uint32_t k = 0; k < recipe.count; ++k) {
    const TourPart& s = recipe.parts[k];
    const std::vector<Code>& from = tours_[s.tour];
    if (!s.reversed)
      tour.insert(tour.end(), from.begin() + s.first, from.begin() + s.last + 1);
    else
      for (std::uint32_t n = s.last + 1; n-- > s.first;) tour.push_back(from[n] ^ 1);
  }
}

void Tours::renumber(std::uint32_t tour) {
  const std::vector<Code>& stops = tours_[tour];
  std::vector<double>& flown_m = flown_m_[tour];
  flown_m.resize(stops.size());
  flown_m[0] = 0;
  std::vector<Load>& carried = carried_[tour];
  carried.assign(stops.size(), {});
  for (std::uint32_t k = 1; k < stops.size(); ++k) {
    const std::uint32_t lot = stops[k] / 2;
    flown_m[k] = flown_m[k - 1] + legs_->length_m(stops[k - 1] ^ 1, stops[k]) + lengths_m_[lot];
    (carried[k] = carried[k - 1]) += loads_[lot];
    if (lot >= owner_.size()) continue;
    owner_[lot] = tour;
    position_[lot] = k;
  }
}

void Tours::apply(const Change& change) {
  make(change.tour_a, fresh_a_);
  if (change.b != Change::none) make(change.tour_b, fresh_b_);
  tours_[change.a].swap(fresh_a_);
  renumber(change.a);
  if (change.b == Change::none) return;
  tours_[change.b].swap(fresh_b_);
  renumber(change.b);
}

Allocation Tours::allocation() const {
  Allocation out(tours_.size());
  for (std::size_t a = 0; a < tours_.size(); ++a)
    for (std::size_t k = 1; k + 1 < tours_[a].size(); ++k)
      out[a].push_back({tours_[a][k] / 2, (tours_[a][k] & 1) != 0});
  return out;
}

}  // namespace arcbid
