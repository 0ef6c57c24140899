// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/coverage/chains.hpp"
#include "core/coverage/parallel.hpp"

namespace arcbid {

namespace {

constexpr int kMostRounds = 4;
constexpr double kGoal = 0.9992, kCameraGoal = 0.997;  // what arcs must cover of fresh samples

double sum_m(const std::vector<Arc>& arcs) {
  double sum = 0;
  for (const Arc& arc : arcs) sum += length_m(arc.waypoints);
  return sum;
}

/// What differs by less may be the same place after it is moved.
constexpr double kSamePlace_m = 1e-6;

std::vector<Arc> in_frame(std::vector<Arc> arcs, const Vec3& offset) {
  for (Arc& arc : arcs) {
    std::vector<Waypoint> moved;
    for (Waypoint w : arc.waypoints) {
      w.position_m += offset;
      if (moved.empty() || (w.position_m - moved.back().position_m).norm() > kSamePlace_m)
        moved.push_back(w);
    }
    arc.waypoints = std::move(moved);
  }
  std::erase_if(arcs, [](const Arc& arc) { return arc.waypoints.size() < 2; });
  return arcs;
}

void append(std::vector<Arc>& arcs, std::vector<Arc> more) {
  std::move(more.begin(), more.end(), std::back_inserter(arcs));
}

TrimLimits trim_limits(const CoverageSettings& s) {
  return {s.spacing_m / 4, 3 * s.spacing_m};
}

/// What the same arcs see of other samples, whose numbers are `first` more.
void add_seen(std::vector<SeenArc>& arcs, const std::vector<SeenArc>& more, std::uint32_t first) {
  for (std::size_t a = 0; a < arcs.size(); ++a)
    for (std::size_t k = 0; k < arcs[a].seen.size(); ++k)
      for (const std::uint32_t s : more[a].seen[k]) arcs[a].seen[k].push_back(first + s);
}

}  // namespace

Completion::Completion(const Structure& structure, const std::vector<Vec3>& ground, double ground_m,
                       const CoverageSettings& settings)
    : settings_(settings),
      threads_(thread_count(settings.threads)),
      floor_m_(ground_m + settings.ground_clearance_m),
      surface_(surface_of(structure, ground, threads_)),
      scene_(surface_),
      flyable_(scene_, surface_,
               {settings.safety_m, floor_m_ - surface_.origin_m.z(),
                std::max(settings.sensor.range_m, settings.standoff_m + settings.safety_m)},
               threads_) {}

Round& Completion::new_round(std::uint64_t seed) {
  rounds_.push_back(
      std::make_unique<Round>(scene_, surface_, flyable_, outlook_, settings_, threads_, seed));
  return *rounds_.back();
}

/// A place inside a closed shell keeps its distance too, but nobody gets there.
void Completion::drop_unreachable(std::vector<Arc>& arcs) {
  std::erase_if(arcs, [&](const Arc& arc) {
    for (const Waypoint& w : arc.waypoints)
      if (flyable_.reaches(w.position_m)) return false;
    unreachable_m_ += length_m(arc.waypoints);
    return true;
  });
}

std::vector<Arc> Completion::filling(const Round& round) {
  const ChainLimits limits{3 * settings_.spacing_m, 30 * settings_.spacing_m,
                           settings_.spacing_m / 4};
  const auto views = views_of_gap(round.seer, flyable_, round.gap, threads_);
  std::vector<Arc> arcs;
  for (std::vector<Waypoint>& chain : chained(views, flyable_, limits, lost_views_))
    arcs.push_back({{}, ArcKind::gap, std::move(chain)});
  return arcs;
}

std::vector<Arc> Completion::first_round(std::vector<Arc> arcs, PlannedCoverage& planned) {
  Round& round = new_round(settings_.seed);
  std::vector<SeenArc> looked = look_along(round.seer, arcs, round.wanted, threads_);
  round.mark_covered(looked);
  const std::vector<SeenArc> again =
      look_along(round.seer, std::move(arcs), round.judge(outlook_, threads_), threads_);
  round.mark_covered(again);
  add_seen(looked, again, 0);
  round.find_gap();
  planned.samples = round.samples.size();
  planned.covered_by_base = round.count_covered();
  planned.visible = planned.covered_by_base + round.gap.samples.size();
  if (settings_.fill) {
    std::vector<SeenArc> more = look_along(round.seer, filling(round), round.wanted, threads_);
    round.mark_covered(more);
    std::move(more.begin(), more.end(), std::back_inserter(looked));
  }
  planned.covered = round.count_covered();
  for (const SeenArc& arc : looked) planned.filled_m += arc.at_m.back();
  std::vector<Arc> all;
  if (!settings_.trim)
    for (SeenArc& arc : looked) all.push_back(std::move(arc.arc));
  else
    all = trimmed(std::move(looked), round.samples.size(), trim_limits(settings_));
  return all;
}

/// Samples that the plan was not made with show what it misses.
void Completion::further_rounds(std::vector<Arc>& arcs) {
  const double goal = settings_.sensor.kind == SensorKind::camera ? kCameraGoal : kGoal;
  for (int k = 1; k < kMostRounds; ++k) {
    Round& round = new_round(settings_.seed + static_cast<std::uint64_t>(k) * 1'000'003);
    round.mark_covered(seen_along(round.seer, arcs, round.wanted, threads_));
    round.mark_covered(seen_along(round.seer, arcs, round.judge(outlook_, threads_), threads_));
    round.find_gap();
    append(arcs, filling(round));
    const auto covered = static_cast<double>(round.count_covered());
    if (covered >= goal * (covered + static_cast<double>(round.gap.samples.size()))) return;
  }
}

/// Of the arcs that fill gaps, what samples of no round need: those of one round often serve
/// another's.
std::vector<Arc> Completion::without_spare_gaps(std::vector<Arc> arcs) const {
  const auto gaps = std::stable_partition(arcs.begin(), arcs.end(),
                                          [](const Arc& a) { return a.kind != ArcKind::gap; });
  const std::vector<Arc> fillers(gaps, arcs.end());
  arcs.erase(gaps, arcs.end());
  std::vector<SeenArc> looked;
  std::uint32_t samples = 0;
  for (const std::unique_ptr<Round>& round : rounds_) {
    const std::vector<bool> others = seen_along(round->seer, arcs, round->wanted, threads_);
    std::vector<SeenArc> seen =
        look_along(round->seer, fillers, round->wanted_without(others), threads_);
    if (looked.empty())
      looked = std::move(seen);
    else
      add_seen(looked, seen, samples);
    samples += static_cast<std::uint32_t>(round->samples.size());
  }
  append(arcs, trimmed(std::move(looked), samples, trim_limits(settings_)));
  return arcs;
}

void Completion::say_what_is_lost(std::vector<std::string>& warnings) const {
  if (unreachable_m_ > 0)
    warnings.push_back(fmt::format(
        "{:.1f} m of path lines left out: there is no way to them from outside", unreachable_m_));
  if (lost_views_ > 0)
    warnings.push_back(fmt::format(
        "{} viewpoints left out: there is no room to fly even a short line there", lost_views_));
}

void Completion::run(ArcPlan& plan) {
  std::vector<Arc> arcs = in_frame(std::move(plan.arcs), -surface_.origin_m);
  plan.planned.base_m = sum_m(arcs);
  drop_unreachable(arcs);
  arcs = first_round(std::move(arcs), plan.planned);
  if (settings_.fill) further_rounds(arcs);
  if (settings_.trim)
    arcs = joined_ends(without_spare_gaps(std::move(arcs)), flyable_,
                       {settings_.spacing_m, 30 * settings_.spacing_m});
  plan.planned.planned_m = sum_m(arcs);
  plan.arcs = in_frame(std::move(arcs), surface_.origin_m);
  // To the frame of their own and back, by rounding they may have come under the floor.
  for (Arc& arc : plan.arcs)
    for (Waypoint& w : arc.waypoints) w.position_m.z() = std::max(w.position_m.z(), floor_m_);
  for (std::size_t a = 0; a < plan.arcs.size(); ++a)
    plan.arcs[a].id.value = static_cast<std::uint32_t>(a);
  say_what_is_lost(plan.warnings);
}

}  // namespace arcbid
