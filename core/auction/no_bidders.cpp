// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/no_bidders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/auction/limits.hpp"

namespace arcbid {
namespace {

using Path = std::vector<PathStop>;

/// The tour home to home, and where each stop of it begins and ends.
class Tour {
 public:
  Tour(const TaskSet& set, const Uav& uav, const Transit& transit, const Path& path)
      : set_(set), uav_(uav), transit_(transit) {
    ends_m_.push_back(uav.home_m);
    for (const PathStop& stop : path) {
      const Task& task = set.tasks[stop.task.value];
      begins_m_.push_back(stop.reversed ? task.last_m : task.first_m);
      ends_m_.push_back(stop.reversed ? task.first_m : task.last_m);
      flown_m_ += task.length_m();
    }
    if (set_.return_home) begins_m_.push_back(uav.home_m);
    for (std::size_t l = 0; l < begins_m_.size(); ++l)
      flown_m_ += transit_.length_m(ends_m_[l], begins_m_[l]);
  }

  /// With `task` at the best place from `first` on, either way.
  double least_with_m(const Task& task, std::size_t first) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t l = first; l < ends_m_.size(); ++l)
      for (const auto& [begin_m, end_m] :
           {std::pair(task.first_m, task.last_m), std::pair(task.last_m, task.first_m)}) {
        double added_m = transit_.length_m(ends_m_[l], begin_m) + task.length_m();
        if (l < begins_m_.size())
          added_m +=
              transit_.length_m(end_m, begins_m_[l]) - transit_.length_m(ends_m_[l], begins_m_[l]);
        least_m = std::min(least_m, flown_m_ + added_m);
      }
    return least_m;
  }
  std::size_t stops() const { return ends_m_.size() - 1; }

 private:
  const TaskSet& set_;
  const Uav& uav_;
  const Transit& transit_;
  std::vector<Vec3> begins_m_, ends_m_;
  double flown_m_ = 0;
};

class Search {
 public:
  Search(const std::vector<Winnings>& members, const TaskSet& set, const AuctionSettings& settings,
         const Transit& transit)
      : members_(members), set_(set), settings_(settings), transit_(transit) {}

  std::vector<NoBidder> found() {
    std::vector<bool> is_taken(set_.tasks.size(), false);
    for (const Winnings& member : members_)
      for (const TaskId task : member.taken) is_taken[task.value] = true;
    std::vector<NoBidder> all;
    std::vector<Task> stretches;
    for (const Task& task : set_.tasks) {
      if (is_taken[task.id.value]) continue;
      const NoBidderReason why = reason_of(task);
      const bool goes_on = !all.empty() && all.back().arc == task.arc && all.back().why == why &&
                           all.back().to_m == task.from_m;
      if (goes_on) {
        all.back().to_m = stretches.back().to_m = task.to_m;
        stretches.back().last_m = task.last_m;
      } else {
        NoBidder& left = all.emplace_back();
        left.arc = task.arc;
        left.from_m = task.from_m;
        left.to_m = task.to_m;
        left.why = why;
        left.needs = task.payload;
        stretches.push_back(task);
      }
    }
    for (std::size_t n = 0; n < all.size(); ++n) complete(all[n], stretches[n]);
    return all;
  }

 private:
  bool has_room(const Winnings& member) const {
    return settings_.bundle_limit == 0 || member.taken.size() < settings_.bundle_limit;
  }
  double alone_m(const Uav& uav, const Task& task) const {
    return Tour(set_, uav, transit_, {}).least_with_m(task, 0);
  }

  NoBidderReason reason_of(const Task& task) const {
    auto why = NoBidderReason::payload;
    for (const Winnings& member : members_) {
      const Limits limits(member.uav);
      if (!limits.serves(task)) continue;
      if (!limits.lasts(alone_m(member.uav, task)))
        why = std::max(why, NoBidderReason::endurance);
      else if (has_room(member))
        return NoBidderReason::endurance_left;
      else
        why = NoBidderReason::bundle_limit;
    }
    return why;
  }

  void complete(NoBidder& left, const Task& stretch) const {
    if (left.why == NoBidderReason::bundle_limit) left.limit = settings_.bundle_limit;
    const bool alone = left.why == NoBidderReason::endurance;
    const bool with_all = left.why == NoBidderReason::endurance_left &&
                          std::ranges::all_of(members_, [](const Winnings& member) {
                            return member.path.has_value();
                          });
    if (!alone && !with_all) return;
    const bool at_end = settings_.score == ScoreKind::independent ||
                        settings_.score == ScoreKind::discounted_append;
    for (const Winnings& member : members_) {
      const Uav& uav = member.uav;
      if (!Limits(uav).serves(stretch) || !uav.endurance_s) continue;
      if (with_all && !has_room(member)) continue;
      const Tour tour = Tour(set_, uav, transit_, with_all ? *member.path : Path{});
      const double needed_s = tour.least_with_m(stretch, at_end ? tour.stops() : 0) / uav.speed_mps;
      if (left.nearest && !(needed_s - *uav.endurance_s < left.needed_s - left.endurance_s))
        continue;
      left.nearest = uav.id;
      left.needed_s = needed_s;
      left.endurance_s = *uav.endurance_s;
    }
    // Pieces joined, or bids that insert elsewhere: it lasts, and yet nobody could bid.
    if (left.nearest && left.needed_s <= left.endurance_s) {
      left.nearest.reset();
      left.needed_s = left.endurance_s = 0;
    }
  }

  const std::vector<Winnings>& members_;
  const TaskSet& set_;
  const AuctionSettings& settings_;
  const Transit& transit_;
};

/// To a tenth, so that what is too little also looks it.
double up(double seconds) {
  return std::ceil(10 * seconds) / 10;
}
double down(double seconds) {
  return std::floor(10 * seconds) / 10;
}

}  // namespace

std::string reason(const NoBidder& left) {
  switch (left.why) {
    case NoBidderReason::payload:
      return fmt::format("no bidder: needs a {}, nobody carries one", name_of(left.needs));
    case NoBidderReason::endurance:
      if (!left.nearest) return "no bidder: nobody lasts long enough";
      return fmt::format("no bidder: needs {:.1f} s, best endurance {:.1f} s (agent {})",
                         up(left.needed_s), down(left.endurance_s), left.nearest->value);
    case NoBidderReason::bundle_limit:
      return fmt::format("no bidder: all who could fly it have {} tasks, the bundle limit",
                         left.limit);
    case NoBidderReason::endurance_left:
      break;
  }
  const std::string nobody = "no bidder: nobody has endurance left for it";
  if (!left.nearest || left.needed_s <= left.endurance_s) return nobody;
  return fmt::format("{}: agent {} lacks {:.1f} s", nobody, left.nearest->value,
                     up(left.needed_s - left.endurance_s));
}

std::string to_text(const NoBidder& left) {
  return fmt::format("arc {}, {:.1f} to {:.1f} m: {}", left.arc.value, left.from_m, left.to_m,
                     reason(left));
}

std::vector<PathStop> path_of(const std::vector<TaskId>& taken, const TaskSet& set, const Uav& uav,
                              const AuctionSettings& settings, const Transit& transit) {
  const auto score = make_score(set, uav, settings, transit);
  for (const TaskId task : taken) score->insert(task, score->best(task));
  return score->path();
}

std::vector<NoBidder> no_bidders(const std::vector<Winnings>& members, const TaskSet& set,
                                 const AuctionSettings& settings, const Transit& transit) {
  return Search(members, set, settings, transit).found();
}

}  // namespace arcbid
