// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace arcbid {

namespace {

constexpr std::size_t kNeighbours = 10;
constexpr std::size_t kMostImproved =
    200;  // views of a chain that 2-opt, which is quadratic, takes
constexpr double kLeastLine_m = 0.5;
constexpr double kAside_m = 0.2;  // little for what is seen, and yet a leg on which a look can turn

using Leg = std::tuple<double, std::uint32_t, std::uint32_t>;  // metres, from < to

double apart_m(const Waypoint& a, const Waypoint& b) {
  return (a.position_m - b.position_m).norm();
}

/// From each view to the nearest others, shortest first.
std::vector<Leg> short_legs(const std::vector<Waypoint>& views, double most_m) {
  std::vector<std::uint32_t> by_x(views.size());
  std::iota(by_x.begin(), by_x.end(), 0u);
  const auto x = [&](std::uint32_t v) { return views[v].position_m.x(); };
  std::sort(by_x.begin(), by_x.end(),
            [&](auto a, auto b) { return x(a) != x(b) ? x(a) < x(b) : a < b; });
  std::vector<Leg> legs, own;
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    own.clear();
    const auto visit = [&](std::size_t j) {
      const auto [a, b] = std::minmax(by_x[i], by_x[j]);
      if (std::abs(x(a) - x(b)) > most_m) return false;
      if (const double m = apart_m(views[a], views[b]); m <= most_m) own.emplace_back(m, a, b);
      return true;
    };
    for (std::size_t j = i + 1; j < by_x.size() && visit(j);) ++j;
    for (std::size_t j = i; j > 0 && visit(j - 1);) --j;
    std::sort(own.begin(), own.end());
    own.resize(std::min(own.size(), kNeighbours));
    legs.insert(legs.end(), own.begin(), own.end());
  }
  std::sort(legs.begin(), legs.end());
  legs.erase(std::unique(legs.begin(), legs.end()), legs.end());
  return legs;
}

/// Open polylines under construction: each view has up to two neighbours.
class Paths {
 public:
  explicit Paths(std::size_t count) : next_(count), owner_(count), length_m_(count, 0.0) {
    std::iota(owner_.begin(), owner_.end(), 0u);
  }

  bool may_join(const Leg& leg, double most_m) {
    const auto [m, a, b] = leg;
    return next_[a].size() < 2 && next_[b].size() < 2 && find(a) != find(b) &&
           length_m_[find(a)] + length_m_[find(b)] + m <= most_m;
  }
  void join(const Leg& leg) {
    const auto [m, a, b] = leg;
    next_[a].push_back(b);
    next_[b].push_back(a);
    length_m_[find(a)] += length_m_[find(b)] + m;
    owner_[find(b)] = find(a);
  }
  std::vector<std::vector<std::uint32_t>> all() const {
    std::vector<std::vector<std::uint32_t>> paths;
    std::vector<bool> done(next_.size());
    for (std::uint32_t v = 0; v < next_.size(); ++v) {
      if (done[v] || next_[v].size() == 2) continue;
      std::vector<std::uint32_t> path{v};
      done[v] = true;
      for (bool grew = true; grew;) {
        grew = false;
        for (const std::uint32_t n : next_[path.back()])
          if (!done[n]) {
            done[n] = grew = true;
            path.push_back(n);
            break;
          }
      }
      paths.push_back(std::move(path));
    }
    return paths;
  }

 private:
  std::uint32_t find(std::uint32_t v) {
    while (owner_[v] != v) v = owner_[v] = owner_[owner_[v]];
    return v;
  }
  std::vector<std::vector<std::uint32_t>> next_;
  std::vector<std::uint32_t> owner_;
  std::vector<double> length_m_;
};

/// Reverses stretches as long as that makes the chain shorter and its new legs may be flown.
void improve(std::vector<Waypoint>& chain, const Flyable& flyable) {
  if (chain.size() < 3 || chain.size() > kMostImproved) return;
  const auto leg_m = [&](std::size_t a, std::size_t b) { return apart_m(chain[a], chain[b]); };
  const auto free = [&](std::size_t a, std::size_t b) {
    return flyable.clears(chain[a].position_m, chain[b].position_m);
  };
  const std::size_t n = chain.size();
  for (bool better = true; better;) {
    better = false;
    // Reversing i..j renews the leg into i and the leg out of j; an open chain may lack either.
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        double gain_m = 0;
        if (i > 0) gain_m += leg_m(i - 1, i) - leg_m(i - 1, j);
        if (j + 1 < n) gain_m += leg_m(j, j + 1) - leg_m(i, j + 1);
        if (gain_m < 1e-6 || (i > 0 && !free(i - 1, j)) || (j + 1 < n && !free(i, j + 1))) continue;
        std::reverse(chain.begin() + static_cast<std::ptrdiff_t>(i),
                     chain.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        better = true;
      }
  }
}

/// A line from the view to where there is most room around.
std::optional<std::vector<Waypoint>> line_at(const Waypoint& view, const Flyable& flyable,
                                             double wanted_m) {
  for (double m = wanted_m; m >= std::min(wanted_m, kLeastLine_m) / 4; m /= 2) {
    double most = -1;
    Vec3 best = Vec3::Zero();
    for (int k = 0; k < 27; ++k) {
      if (k == 13) continue;
      const Vec3 way = m * Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1).normalized();
      const double spare = flyable.spare_m(view.position_m + way);
      if (spare > most + 1e-9 && flyable.clears(view.position_m, view.position_m + way)) {
        most = spare;
        best = way;
      }
    }
    if (most >= 0) return std::vector<Waypoint>{view, {view.position_m + best, view.look}};
  }
  return std::nullopt;
}

/// Neighbours on an arc must not be on one spot: where several views share a place, all but the
/// first move aside a little.
std::vector<Waypoint> apart(std::vector<Waypoint> views, const Flyable& flyable) {
  std::map<std::array<double, 3>, int> used;
  for (Waypoint& view : views) {
    const Vec3 p = view.position_m;
    int& count = used[{p.x(), p.y(), p.z()}];
    for (int tries = 0; count > 0 && tries < 26; ++tries) {
      const int k = (count + tries) % 26, d = k < 13 ? k : k + 1;
      const Vec3 to = p + kAside_m * Vec3(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1).normalized();
      if (!flyable.clears(p, to)) continue;
      view.position_m = to;
      count += tries;
      break;
    }
    ++count;
  }
  return views;
}

}  // namespace

std::vector<std::vector<Waypoint>> chained(const std::vector<Waypoint>& wanted,
                                           const Flyable& flyable, const ChainLimits& limits,
                                           std::size_t& lost) {
  const std::vector<Waypoint> views = apart(wanted, flyable);
  Paths paths(views.size());
  for (const Leg& leg : short_legs(views, limits.leg_m)) {
    const auto& [m, a, b] = leg;
    if (m > 1e-6 && paths.may_join(leg, limits.chain_m) &&
        flyable.clears(views[a].position_m, views[b].position_m))
      paths.join(leg);
  }
  std::vector<std::vector<Waypoint>> chains;
  for (const std::vector<std::uint32_t>& path : paths.all()) {
    std::vector<Waypoint> chain;
    for (const std::uint32_t v : path) chain.push_back(views[v]);
    improve(chain, flyable);
    if (chain.size() == 1) {
      const auto line = line_at(chain.front(), flyable, limits.lone_m);
      if (!line) {
        ++lost;
        continue;
      }
      chain = *line;
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace arcbid
