// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "sim/checker/checks.hpp"

namespace arcbid::checker {

namespace {

/// Where one is after `at_m` along the arc.
Point place(const Path& path, double at_m) {
  for (std::size_t n = 1; n < path.size(); ++n) {
    const Point &from = path[n - 1].position_m, &to = path[n].position_m;
    const double step_m = distance(from, to);
    if (at_m <= step_m || n + 1 == path.size()) {
      const double share = step_m > 0 ? std::clamp(at_m / step_m, 0.0, 1.0) : 0;
      return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
              from.z + share * (to.z - from.z)};
    }
    at_m -= step_m;
  }
  return path.front().position_m;
}

/// One record, and what contradicts it.
class Reason {
 public:
  Reason(const Published& published, const std::vector<Delivered>& all, const Left& left,
         Problems& problems)
      : published_(published),
        all_(all),
        left_(left),
        arc_(published.arcs.at(left.arc)),
        problems_(problems) {}

  void check() {
    if (left_.needs != arc_.payload)
      deny(fmt::format("it needs {}, not {}", arc_.payload, left_.needs));
    check_rows();
    if (left_.agent) check_nearest();
    for (const Delivered& delivered : all_) {
      const auto uav = published_.fleet.find(delivered.agent);
      if (uav != published_.fleet.end() && uav->second.serves(arc_.payload))
        check_by(delivered, uav->second);
    }
    const std::string known[] = {"payload", "endurance", "endurance-left", "bundle-limit"};
    if (std::ranges::find(known, left_.why) == std::end(known))
      deny(fmt::format("'{}' is no reason", left_.why));
  }

 private:
  void deny(const std::string& what) {
    problems_.add(fmt::format("arc {} {} to {} m is said to have no bidder ({}): {}", left_.arc,
                              left_.from_m, left_.to_m, left_.why, what));
  }

  void check_rows() {
    for (const TaskRow& row : all_[0].tasks) {
      const double shared_m = std::min(row.to_m, left_.to_m) - std::max(row.from_m, left_.from_m);
      if (row.arc == left_.arc && row.owner && shared_m > kTolerance_m)
        deny(fmt::format("task {} of it is agent {}'s", row.task, *row.owner));
    }
  }

  void check_nearest() {
    const auto uav = published_.fleet.find(*left_.agent);
    if (uav == published_.fleet.end() || uav->second.endurance_s != left_.endurance_s)
      return deny(
          fmt::format("agent {} has no endurance of {} s", *left_.agent, left_.endurance_s));
    const double least_s = straight_s(uav->second);
    if (!(left_.needed_s > left_.endurance_s) || left_.needed_s < least_s - kTolerance_m)
      deny(
          fmt::format("{} s, of which flying there, along it and back take {:.4f}, are not more "
                      "than {}",
                      left_.needed_s, least_s, left_.endurance_s));
  }

  /// Why an agent that serves it does not fly it.
  void check_by(const Delivered& delivered, const FleetAgent& uav) {
    const auto won = static_cast<std::size_t>(
        std::ranges::count(delivered.tasks, std::optional(delivered.agent), &TaskRow::won_by));
    const std::string who = fmt::format("agent {} ", delivered.agent);
    if (left_.why == "payload")
      deny(who + "carries " + uav.payload);
    else if (left_.why == "bundle-limit" && (won > left_.limit || left_.limit == 0))
      deny(who + fmt::format("won {} tasks, the limit is {}", won, left_.limit));
    else if (left_.why == "bundle-limit" && won < left_.limit && !uav.endurance_s)
      deny(who + fmt::format("won {} tasks and may take {}", won, left_.limit));
    else if (left_.why != "bundle-limit" && !uav.endurance_s)
      deny(who + "has no limit to its endurance");
    else if (has_room(won) && published_.transits_are_straight && uav.endurance_s &&
             straight_s(uav) < *uav.endurance_s)
      deny(who +
           fmt::format("could fly it alone in {:.4f} s of {}", straight_s(uav), *uav.endurance_s));
  }

  /// For one more, where it is said that there was none, or that it would not help.
  bool has_room(std::size_t won) const {
    return left_.why == "endurance" || (left_.why == "bundle-limit" && won < left_.limit);
  }

  double straight_s(const FleetAgent& uav) const {
    const double way_m = distance(uav.home_m, place(arc_.waypoints, left_.from_m)) +
                         distance(uav.home_m, place(arc_.waypoints, left_.to_m));
    return (way_m + left_.to_m - left_.from_m) / uav.speed_mps;
  }

  const Published& published_;
  const std::vector<Delivered>& all_;
  const Left& left_;
  const PublishedArc& arc_;
  Problems& problems_;
};

}  // namespace

bool holds(const Left& left, std::uint32_t arc, double from_m, double to_m) {
  return left.arc == arc && left.from_m <= from_m + kTolerance_m &&
         left.to_m >= to_m - kTolerance_m;
}

void check_left(const Published& published, const std::vector<Delivered>& all, Problems& problems) {
  for (const Left& left : all[0].left) {
    if (published.arcs.contains(left.arc))
      Reason(published, all, left, problems).check();
    else
      problems.add(fmt::format("arc {}, said to have no bidder, was never published", left.arc));
  }
}

}  // namespace arcbid::checker
