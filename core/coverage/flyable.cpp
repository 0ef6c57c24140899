// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/flyable.hpp"

#include <algorithm>
#include <cmath>

#include "core/coverage/parallel.hpp"

namespace arcbid {

namespace {

constexpr double kMostCells = 64e6;
constexpr int kBlock = 16;              // cells along a block that one thread classifies
constexpr double kMargin = 0.002;       // of the safety distance, for whoever measures in floats
constexpr double kLeastStep_m = 0.004;  // of the same order: between two places that keep a
                                        // distance d a segment keeps d - step / 2

}  // namespace

Flyable::Flyable(const Scene& scene, const Surface& surface, const Limits& limits, unsigned threads)
    : scene_(scene),
      required_m_(limits.safety_m * (1 + kMargin)),
      floor_m_(limits.floor_z_m),
      cell_m_(limits.safety_m / 4) {
  Vec3 low = surface.points.front(), high = low;
  const auto include = [&](const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  for (const Vec3& p : surface.points) include(p);
  low.array() -= limits.around_m;
  high.array() += limits.around_m;
  low.z() = std::max(low.z(), floor_m_ - 1e-9);
  high.z() = std::max(high.z(), low.z() + limits.around_m);
  const Vec3 size = high - low;
  cell_m_ = std::max(cell_m_, std::cbrt(size.prod() / kMostCells));
  low_m_ = low;
  // Centres start on the floor, which is where the room below a structure is least.
  low_m_.z() -= cell_m_ / 2 - 1e-9;
  for (int k = 0; k < 3; ++k) cells_[k] = static_cast<int>(std::ceil(size[k] / cell_m_)) + 1;
  state_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], kUnknown);
  classify_all(threads);
  flood();
}

Vec3 Flyable::centre(const Cell& c) const {
  return low_m_ + cell_m_ * Vec3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
}

double Flyable::spare_m(const Vec3& p, double most_m) const {
  return scene_.distance_m(p, required_m_ + most_m) - required_m_;
}

/// One exact distance settles a whole cube that is far from where the distance is the required one;
/// any other falls into eight.
void Flyable::classify(const Cell& low, int size) {
  if (!inside(low)) return;
  const double half_m = 0.5 * (size - 1) * cell_m_;  // from the middle to the outermost centres
  const Vec3 middle = centre(low) + Vec3::Constant(half_m);
  const double reach_m = half_m * std::sqrt(3.0);
  const double spare = spare_m(middle, reach_m + cell_m_);
  const bool open = spare >= reach_m + cell_m_ / 2, blocked = spare < -reach_m;
  if (size > 1 && !open && !blocked) {
    const int half = size / 2;
    for (int k = 0; k < 8; ++k)
      classify({low[0] + (k & 1) * half, low[1] + (k >> 1 & 1) * half, low[2] + (k >> 2) * half},
               half);
    return;
  }
  const State state = open ? kOpen : blocked ? kBlocked : kTight;
  for (int z = low[2]; z < std::min(low[2] + size, cells_[2]); ++z)
    for (int y = low[1]; y < std::min(low[1] + size, cells_[1]); ++y)
      std::fill_n(state_.begin() + static_cast<std::ptrdiff_t>(index({low[0], y, z})),
                  std::min(size, cells_[0] - low[0]), state);
}

void Flyable::classify_all(unsigned threads) {
  const auto blocks = [](int cells) {
    return static_cast<std::size_t>((cells + kBlock - 1) / kBlock);
  };
  const std::size_t bx = blocks(cells_[0]), by = blocks(cells_[1]), bz = blocks(cells_[2]);
  for_chunks(bx * by * bz, 4, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t b = from; b < to; ++b)
      classify({static_cast<int>(b % bx) * kBlock, static_cast<int>(b / bx % by) * kBlock,
                static_cast<int>(b / bx / by) * kBlock},
               kBlock);
  });
}

/// Between two open centres the distance cannot fall below the required one; else it is asked.
bool Flyable::linked(const Cell& from, State from_state, const Cell& to, State to_state) const {
  return (from_state == kOpen && to_state == kOpen) || clears(centre(from), centre(to));
}

/// From the grid's top inward. Open cells that were reached through a tight one are
/// marked all the same.
void Flyable::flood() {
  std::vector<std::pair<Cell, State>> stack;
  const auto reach = [&](const Cell& c) {
    State& state = state_[index(c)];
    if (state != kOpen && state != kTight) return;
    stack.emplace_back(c, state);
    state = kReached;
  };
  for (int x = 0; x < cells_[0]; ++x)
    for (int y = 0; y < cells_[1]; ++y) reach({x, y, cells_[2] - 1});
  while (!stack.empty()) {
    const auto [c, state] = stack.back();
    stack.pop_back();
    for (int k = 0; k < 6; ++k) {
      Cell n = c;
      n[k / 2] += k % 2 ? 1 : -1;
      if (!inside(n)) continue;
      const State there = state_[index(n)];
      if ((there == kOpen || there == kTight) && linked(c, state, n, there)) reach(n);
    }
  }
}

bool Flyable::clears(const Vec3& from, const Vec3& to) const {
  if (std::min(from.z(), to.z()) < floor_m_) return false;
  const double length_m = (to - from).norm();
  const double least_m = std::min(kLeastStep_m, required_m_ * kMargin);
  for (double at_m = 0;;) {
    const Vec3 p = at_m < length_m ? Vec3(from + at_m / length_m * (to - from)) : to;
    const double spare = spare_m(p);
    if (spare < 0) return false;
    // What is spare here is spare, less, for as long in both directions.
    if (at_m >= length_m || spare >= length_m - at_m) return true;
    at_m += std::max(spare, least_m);
  }
}

bool Flyable::reaches(const Vec3& p) const {
  if (!clears(p)) return false;
  const Cell home = cell_of(p);
  // Beyond the grid there is nothing in the way; above and beside it is outside.
  if (!inside(home)) return true;
  for (int k = 0; k < 27; ++k) {
    // The cell itself first, then its neighbours.
    const int n = (k + 13) % 27;
    const Cell c{home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1};
    if (reached(c) && clears(p, centre(c))) return true;
  }
  return false;
}

}  // namespace arcbid
