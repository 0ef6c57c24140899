// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/limits.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/world/checkers/greedy.hpp"

namespace arcbid {
namespace {

constexpr double rounding_m = 1e-3;  // of where a stretch begins and ends

}  // namespace

bool carries(const Uav& uav, Payload needed) {
  return uav.payload == needed || uav.payload == Payload::any || needed == Payload::any;
}

bool lasts(const Uav& uav, double tour_s) {
  constexpr double rounding = 1e-9;
  return !uav.endurance_s || tour_s <= *uav.endurance_s * (1 + rounding);
}

const Uav& LimitsChecker::uav(AgentId agent) const {
  for (const Uav& uav : mission_.fleet)
    if (uav.id == agent) return uav;
  throw std::logic_error("a proof speaks of an agent that is not of the fleet");
}

Payload LimitsChecker::needs(std::size_t task) const {
  return mission_.arcs.at(pieces_.at(task).arc).payload;
}

/// Whether there is a place for the task where the score may put it.
bool LimitsChecker::can_add(const Uav& uav, const std::vector<PathStop>& path,
                            std::size_t task) const {
  if (!carries(uav, needs(task))) return false;
  const ScoreKind score = mission_.auction.score;
  const bool at_end = score == ScoreKind::independent || score == ScoreKind::discounted_append;
  for (std::size_t l = at_end ? path.size() : 0; l <= path.size(); ++l)
    for (const bool reversed : {false, true}) {
      std::vector<PathStop> longer = path;
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(l),
                    {{static_cast<std::uint32_t>(task)}, reversed});
      if (lasts(uav, closed_path_s(pieces_, uav, longer, transit_))) return true;
    }
  return false;
}

NoBidderReason LimitsChecker::reason(const Agreement& proof, std::size_t task) const {
  const std::size_t limit = mission_.auction.bundle_limit;
  bool anybody_carries = false, anybody_lasts = false;
  for (const AgentId member : proof.members) {
    const auto won = [member](const Belief& belief) { return belief.winner == member; };
    anybody_carries = anybody_carries || carries(uav(member), needs(task));
    if (!can_add(uav(member), {}, task)) continue;
    anybody_lasts = true;
    if (limit == 0 || std::ranges::count_if(proof.winners, won) < std::ptrdiff_t(limit))
      return NoBidderReason::endurance_left;
  }
  if (anybody_lasts) return NoBidderReason::bundle_limit;
  return anybody_carries ? NoBidderReason::endurance : NoBidderReason::payload;
}

void LimitsChecker::check_own(const SeenStep& step) const {
  const std::vector<PathStop>& path = step.update.agreed->path;
  const Uav& self = uav(step.agent);
  const double tour_s = closed_path_s(pieces_, self, path, transit_);
  if (!lasts(self, tour_s))
    findings_.add(step.now_ns, "limits", "agent {} flies {} s and lasts {} s", step.agent.value,
                  tour_s, *self.endurance_s);
  for (const PathStop& stop : path)
    if (!carries(self, needs(stop.task.value)))
      findings_.add(step.now_ns, "limits", "agent {} carries no {} for task {}", step.agent.value,
                    name_of(needs(stop.task.value)), stop.task.value);
}

void LimitsChecker::check_task(const SeenStep& step, std::size_t task) const {
  const Agreement& proof = *step.update.agreed;
  const Stretch& piece = pieces_[task];
  const auto is_here = [&](const NoBidder& left) {
    return left.arc.value == piece.arc && left.from_m < piece.to_m - rounding_m &&
           left.to_m > piece.from_m + rounding_m;
  };
  const auto said = std::ranges::find_if(proof.left, is_here);
  const bool is_said = said != proof.left.end();
  if (proof.winners[task].winner.has_value() == is_said)
    findings_.add(step.now_ns, "limits", "agent {} proves task {} {}", step.agent.value, task,
                  is_said ? "won and without a bidder" : "not won, and gives no reason");
  if (proof.winners[task].winner) return;
  if (is_said && said->why != reason(proof, task))
    findings_.add(step.now_ns, "limits", "task {} is left for {}, agent {} says for {}", task,
                  name_of(reason(proof, task)), step.agent.value, name_of(said->why));
  if (is_said && said->nearest && !(said->needed_s > said->endurance_s))
    findings_.add(step.now_ns, "limits", "task {} is left though {} s are not more than {}", task,
                  said->needed_s, said->endurance_s);
  const std::size_t limit = mission_.auction.bundle_limit;
  const bool has_room = limit == 0 || proof.path.size() < limit;
  if (has_room && can_add(uav(step.agent), proof.path, task))
    findings_.add(step.now_ns, "limits", "nobody has task {}, and agent {} could fly it", task,
                  step.agent.value);
}

void LimitsChecker::after(const SeenStep& step) {
  if (!step.update.agreed || step.update.agreed->winners.size() != pieces_.size()) return;
  check_own(step);
  for (std::size_t task = 0; task < pieces_.size(); ++task) check_task(step, task);
}

}  // namespace arcbid
