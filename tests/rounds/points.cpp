// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rounds/points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/digest.hpp"

namespace arcbid::testing {
namespace {

using Path = std::vector<TaskId>;

constexpr double none = -std::numeric_limits<double>::infinity();

struct Offer {
  double gain = none;
  TaskId task;
  std::size_t position = 0;
};

double reward(const Instance& in, const Uav& uav, const Path& path, double rho) {
  Vec3 at_m = uav.home_m;
  double sum = 0, length_m = 0;
  for (const TaskId j : path) {
    const Task& task = in.tasks.tasks[j.value];
    length_m += (task.first_m - at_m).norm();
    at_m = task.first_m;
    sum += task.value * std::exp(-rho * length_m / uav.speed_mps);
  }
  return sum;
}

double time_s(const Instance& in, const Uav& uav, const Path& path) {
  Vec3 at_m = uav.home_m;
  double length_m = 0;
  for (const TaskId j : path) {
    length_m += (in.tasks.tasks[j.value].first_m - at_m).norm();
    at_m = in.tasks.tasks[j.value].first_m;
  }
  return length_m / uav.speed_mps;
}

/// What j is worth after all of `path`: no sums of rewards, so that ties stay ties.
double reward_at_end(const Instance& in, const Uav& uav, const Path& path, TaskId j, double rho) {
  Vec3 at_m = uav.home_m;
  double time_s = 0;
  const auto fly_to = [&](TaskId to) {
    time_s += (in.tasks.tasks[to.value].first_m - at_m).norm() / uav.speed_mps;
    at_m = in.tasks.tasks[to.value].first_m;
  };
  for (const TaskId stop : path) fly_to(stop);
  fly_to(j);
  return in.tasks.tasks[j.value].value * std::exp(-rho * time_s);
}

double gain(const Instance& in, const Uav& uav, const AuctionSettings& s, const Path& path,
            TaskId j, std::size_t position) {
  if (s.score == ScoreKind::independent) return reward_at_end(in, uav, {}, j, s.discount_per_s);
  if (s.score == ScoreKind::discounted_append)
    return reward_at_end(in, uav, path, j, s.discount_per_s);
  Path longer = path;
  longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(position), j);
  if (s.score == ScoreKind::minimax) return -time_s(in, uav, longer);
  if (s.score == ScoreKind::minisum) return time_s(in, uav, path) - time_s(in, uav, longer);
  return reward(in, uav, longer, s.discount_per_s) - reward(in, uav, path, s.discount_per_s);
}

Offer best_offer(const Instance& in, const Uav& uav, const AuctionSettings& s, const Path& path,
                 const std::vector<bool>& taken) {
  const bool at_end = s.score == ScoreKind::independent || s.score == ScoreKind::discounted_append;
  Offer best;
  for (std::uint32_t j = 0; j < taken.size(); ++j)
    for (std::size_t l = at_end ? path.size() : 0; !taken[j] && l <= path.size(); ++l) {
      const double c = gain(in, uav, s, path, {j}, l);
      // A gain that equals another but for the order of its sums is no better.
      const double noise = at_end ? 0 : 1e-12 * std::abs(c);
      if (c > best.gain + noise) best = {c, {j}, l};
    }
  return best;
}

double best_of(const Instance& in, std::vector<Path>& paths, std::size_t j, std::uint32_t limit,
               double rho) {
  if (j == in.tasks.tasks.size()) {
    double sum = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) sum += reward(in, in.fleet[i], paths[i], rho);
    return sum;
  }
  double best = none;
  for (Path& path : paths)
    for (std::size_t l = 0; path.size() < limit && l <= path.size(); ++l) {
      path.insert(path.begin() + static_cast<std::ptrdiff_t>(l), TaskId{std::uint32_t(j)});
      best = std::max(best, best_of(in, paths, j + 1, limit, rho));
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(l));
    }
  return best;
}

}  // namespace

Instance random_points(std::uint64_t seed, std::uint32_t agents, std::uint32_t tasks, bool ties) {
  std::uint64_t state = seed;
  const auto unit = [&] {
    state += 0x9e3779b97f4a7c15ULL;
    return static_cast<double>(Digest::mix(state) >> 11) * 0x1p-53;
  };
  const auto coordinate = [&] { return ties ? 250 * std::floor(5 * unit()) : 1000 * unit(); };
  const auto point = [&] {
    const double x_m = coordinate(), y_m = coordinate();
    return Vec3(x_m, y_m, 0);
  };
  Instance instance;
  instance.tasks.return_home = false;
  for (std::uint32_t i = 1; i <= agents; ++i) instance.fleet.push_back({{i}, point(), 10});
  for (std::uint32_t j = 0; j < tasks; ++j) {
    const Vec3 at_m = point();
    instance.tasks.tasks.push_back(
        {.id = {j}, .arc = {j}, .first_m = at_m, .last_m = at_m, .value = ties ? 1 : 0.5 + unit()});
  }
  return instance;
}

std::vector<std::vector<TaskId>> sequential_greedy(const Instance& instance,
                                                   const AuctionSettings& settings) {
  const std::size_t tasks = instance.tasks.tasks.size();
  const std::size_t limit = settings.bundle_limit == 0 ? tasks : settings.bundle_limit;
  std::vector<Path> paths(instance.fleet.size());
  std::vector<double> last_bid(paths.size(), -none);
  std::vector<bool> taken(tasks, false);
  while (true) {
    double best_bid = none;
    std::size_t who = 0;
    Offer what;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (paths[i].size() >= limit) continue;
      const Offer offer = best_offer(instance, instance.fleet[i], settings, paths[i], taken);
      const double bid = std::min(offer.gain, last_bid[i]);
      if (offer.gain > none && bid > best_bid) best_bid = bid, who = i, what = offer;
    }
    if (best_bid == none) return paths;
    paths[who].insert(paths[who].begin() + static_cast<std::ptrdiff_t>(what.position), what.task);
    last_bid[who] = best_bid;
    taken[what.task.value] = true;
  }
}

double best_score(const Instance& instance, std::uint32_t bundle_limit, double discount_per_s) {
  std::vector<Path> paths(instance.fleet.size());
  return best_of(instance, paths, 0, bundle_limit, discount_per_s);
}

}  // namespace arcbid::testing
