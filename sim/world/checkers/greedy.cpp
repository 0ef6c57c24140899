// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/greedy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/world/checkers/limits.hpp"

namespace arcbid {
namespace {

using Path = std::vector<PathStop>;
constexpr double infinity = std::numeric_limits<double>::infinity();

double slack(double value) {
  return 1e-9 * (1 + std::abs(value));
}

/// S and the marginal scores, by their definitions (core/auction/score.hpp), without any cache.
class Worth {
 public:
  Worth(const Mission& mission, const std::vector<Stretch>& pieces, const Uav& uav,
        const Transit& transit)
      : settings_(mission.auction),
        arcs_(mission.arcs),
        pieces_(pieces),
        uav_(uav),
        transit_(transit) {}

  /// c_ij of a path that became `longer` by one task.
  double gain(double before, const Path& longer, TaskId task, bool reversed) const {
    switch (settings_.score) {
      case ScoreKind::minimax:
        return -closed_path_s(pieces_, uav_, longer, transit_);
      case ScoreKind::minimax_long_first:
        return 2 * length_m(task) / uav_.speed_mps - closed_path_s(pieces_, uav_, longer, transit_);
      case ScoreKind::independent:
        return sum({{task, reversed}});
      default:
        return sum(longer) - before;
    }
  }

  /// S of the path; for independent and minimax gains it is not asked for.
  double sum(const Path& path) const {
    if (settings_.score == ScoreKind::minisum) return -closed_path_s(pieces_, uav_, path, transit_);
    Vec3 at = uav_.home_m;
    double t_s = 0, sum = 0;
    for (const PathStop& stop : path) {
      const Stretch& piece = pieces_.at(stop.task.value);
      const double length_m = piece.to_m - piece.from_m;
      t_s += transit_.length_m(at, stop.reversed ? piece.last_m : piece.first_m) / uav_.speed_mps;
      t_s += length_m / uav_.speed_mps;
      at = stop.reversed ? piece.first_m : piece.last_m;
      sum += length_m * std::exp(-settings_.discount_per_s * t_s);
    }
    return sum;
  }

  /// Gains that do not ask for S before.
  bool is_whole_tour() const {
    return settings_.score == ScoreKind::minimax ||
           settings_.score == ScoreKind::minimax_long_first;
  }

  bool carries_payload(TaskId task) const {
    return carries(uav_, arcs_.at(pieces_.at(task.value).arc).payload);
  }
  bool can_last(const Path& path) const {
    return !uav_.endurance_s || lasts(uav_, closed_path_s(pieces_, uav_, path, transit_));
  }

  double best_gain(const Path& path, TaskId task) const {
    const bool at_end = settings_.score == ScoreKind::discounted_append ||
                        settings_.score == ScoreKind::independent;
    const double before = is_whole_tour() ? 0 : sum(path);
    double best = -infinity;
    if (!carries_payload(task)) return best;
    for (std::size_t l = at_end ? path.size() : 0; l <= path.size(); ++l)
      for (const bool reversed : {false, true}) {
        Path longer = path;
        longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(l), {task, reversed});
        if (can_last(longer)) best = std::max(best, gain(before, longer, task, reversed));
      }
    return best;
  }

 private:
  double length_m(TaskId task) const {
    const Stretch& piece = pieces_.at(task.value);
    return piece.to_m - piece.from_m;
  }

  const AuctionSettings& settings_;
  const std::vector<Arc>& arcs_;
  const std::vector<Stretch>& pieces_;
  const Uav& uav_;
  const Transit& transit_;
};

/// One bidder, some steps into its bundle.
class Progress {
 public:
  Progress(const Mission& mission, const std::vector<Stretch>& pieces, const Bidder& bidder,
           const Transit& transit)
      : bidder_(bidder),
        worth_(mission, pieces, bidder.uav, transit),
        limit_(mission.auction.bundle_limit) {}

  AgentId agent() const { return bidder_.uav.id; }
  bool done() const { return taken_ == bidder_.bundle.size(); }
  bool full() const { return limit_ > 0 && taken_ >= limit_; }
  const Claim& next() const { return bidder_.bundle[taken_]; }

  /// The best marginal score over all free tasks.
  double best_gain(const std::vector<bool>& is_free) {
    if (gains_.empty()) {
      gains_.resize(is_free.size());
      for (std::uint32_t j = 0; j < gains_.size(); ++j)
        if (is_free[j]) gains_[j] = worth_.best_gain(path_, {j});
    }
    double best = -infinity;
    for (std::size_t j = 0; j < gains_.size(); ++j)
      if (is_free[j]) best = std::max(best, gains_[j]);
    return best;
  }
  double warped(double gain) const {
    return taken_ == 0 ? gain : std::min(gain, bidder_.bundle[taken_ - 1].bid);
  }

  /// Adds its next task where its path has it in the end; what that was worth, none of it if it
  /// cannot be flown.
  double take() {
    const double before = path_.empty() ? 0 : worth_.sum(path_);
    const TaskId task = next().task;
    ++taken_;
    path_.clear();
    bool reversed = false;
    for (const PathStop& stop : bidder_.path) {
      if (has_taken(stop.task)) path_.push_back(stop);
      if (stop.task == task) reversed = stop.reversed;
    }
    gains_.clear();
    if (!worth_.carries_payload(task) || !worth_.can_last(path_)) return -infinity;
    return worth_.gain(before, path_, task, reversed);
  }

 private:
  bool has_taken(TaskId task) const {
    const auto end = bidder_.bundle.begin() + static_cast<std::ptrdiff_t>(taken_);
    return std::any_of(bidder_.bundle.begin(), end,
                       [task](const Claim& claim) { return claim.task == task; });
  }

  const Bidder& bidder_;
  Worth worth_;
  std::size_t limit_;
  std::size_t taken_ = 0;
  Path path_;
  std::vector<double> gains_;  // by task; empty: not known for the path as it is
};

Progress* highest(std::vector<Progress>& all) {
  Progress* best = nullptr;
  for (Progress& one : all)
    if (!one.done() && (!best || one.next().bid > best->next().bid)) best = &one;
  return best;  // ties: the first, the lower id
}

}  // namespace

double closed_path_s(const std::vector<Stretch>& pieces, const Uav& uav, const Path& path,
                     const Transit& transit) {
  Vec3 at = uav.home_m;
  double metres = 0;
  for (const PathStop& stop : path) {
    const Stretch& piece = pieces.at(stop.task.value);
    metres += transit.length_m(at, stop.reversed ? piece.last_m : piece.first_m);
    metres += piece.to_m - piece.from_m;
    at = stop.reversed ? piece.first_m : piece.last_m;
  }
  return (metres + transit.length_m(at, uav.home_m)) / uav.speed_mps;
}

void check_greedy(const Mission& mission, const std::vector<Stretch>& pieces,
                  const std::vector<Bidder>& bidders, const Transit& transit, TimeNs now_ns,
                  Findings& findings) {
  std::vector<Progress> all;
  for (const Bidder& bidder : bidders) all.emplace_back(mission, pieces, bidder, transit);
  std::vector<bool> is_free(pieces.size(), true);
  while (Progress* winner = highest(all)) {
    const Claim claim = winner->next();
    const auto fail = [&](const char* why, double better, double value) {
      findings.add(now_ns, "greedy", "task {} to agent {} at {}: {}: {} against {}",
                   claim.task.value, winner->agent().value, claim.bid, why, better, value);
    };
    for (Progress& other : all) {
      if (&other == winner || other.full()) continue;
      const double offer = other.warped(other.best_gain(is_free));
      if (offer > claim.bid + slack(offer)) fail("another agent bids more", offer, claim.bid);
    }
    const double best = winner->best_gain(is_free);
    const double bid_of_best = winner->warped(best), limit = slack(best);
    const double gain = winner->take();
    if (gain == -infinity) fail("it cannot fly that", best, gain);
    if (best > gain + limit) fail("another task or place is worth more", best, gain);
    if (std::abs(bid_of_best - claim.bid) > limit) fail("not the bid", bid_of_best, claim.bid);
    is_free.at(claim.task.value) = false;
  }
  for (Progress& one : all)
    if (!one.full() && one.best_gain(is_free) > -infinity)
      findings.add(now_ns, "greedy", "agent {} could fly more of what is left", one.agent().value);
}

}  // namespace arcbid
