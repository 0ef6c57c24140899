// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/coverage/chains.hpp"
#include "core/coverage/parallel.hpp"
#include "core/coverage/visibility.hpp"

namespace arcbid {

namespace {

constexpr double kSample_m = 0.3;  // or less where a small stand-off shows more of the surface
constexpr int kMostRounds = 4;
constexpr double kGoal = 0.9995, kCameraGoal = 0.998;  // of what fresh samples' arcs must cover

double sample_m(const CoverageSettings& s) {
  return std::min(kSample_m, s.sensor.range_m / 8);
}

double sum_m(const std::vector<Arc>& arcs) {
  double sum = 0;
  for (const Arc& arc : arcs) sum += length_m(arc.waypoints);
  return sum;
}

std::vector<Arc> in_frame(std::vector<Arc> arcs, const Vec3& offset) {
  for (Arc& arc : arcs)
    for (Waypoint& w : arc.waypoints) w.position_m += offset;
  return arcs;
}

void append(std::vector<Arc>& arcs, std::vector<Arc> more) {
  std::move(more.begin(), more.end(), std::back_inserter(arcs));
}

}  // namespace

Completion::Completion(const Structure& structure, const std::vector<Vec3>& ground, double ground_m,
                       const CoverageSettings& settings)
    : settings_(settings),
      threads_(thread_count(settings.threads)),
      surface_(surface_of(structure, ground, threads_)),
      scene_(surface_),
      flyable_(scene_, surface_,
               {settings.safety_m, ground_m + settings.ground_clearance_m - surface_.origin_m.z(),
                std::max(settings.sensor.range_m, settings.standoff_m + settings.safety_m)},
               threads_) {}

struct Completion::Round {
  Samples samples;
  Seer seer;
  Visibility visibility;
  std::vector<Wanted> wanted;
  std::vector<bool> covered;
  Gap gap;

  Round(const Completion& c, std::uint64_t seed)
      : samples(sided_samples(c.surface_, sample_m(c.settings_), seed)),
        seer(c.scene_, c.surface_, samples, c.settings_.sensor),
        visibility(seer, c.flyable_, c.settings_.safety_m),
        wanted(samples.size(), Wanted::no),
        covered(samples.size()) {
    const std::vector<bool> open = visibility.open(c.threads_);
    for (std::size_t s = 0; s < open.size(); ++s)
      if (open[s]) wanted[s] = Wanted::narrow;
  }
  Round(const Round&) = delete;

  void mark_covered(const std::vector<SeenArc>& looked) {
    for (const SeenArc& arc : looked)
      for (const Seen& seen : arc.seen)
        for (const std::uint32_t s : seen) covered[s] = true;
  }
  std::size_t count_covered() const {
    return static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
  }
};

/// A place inside a closed shell keeps its distance too, but nobody gets there.
void Completion::drop_unreachable(std::vector<Arc>& arcs) {
  std::erase_if(arcs, [&](const Arc& arc) {
    for (const Waypoint& w : arc.waypoints)
      if (flyable_.reaches(w.position_m)) return false;
    unreachable_m_ += length_m(arc.waypoints);
    return true;
  });
}

/// Of what the arcs do not cover: what can be seen, and by which sensor. What only the nominal one
/// can see is then asked of the arcs too, and noted with them.
void Completion::judge(Round& round, std::vector<SeenArc>& looked) const {
  round.mark_covered(looked);
  Seen rest;
  for (std::uint32_t s = 0; s < round.covered.size(); ++s)
    if (round.wanted[s] != Wanted::no && !round.covered[s]) rest.push_back(s);
  const auto witnesses = round.visibility.witnesses(rest, threads_);
  std::vector<Wanted> nominal(round.wanted.size(), Wanted::no);
  for (std::size_t k = 0; k < rest.size(); ++k) {
    round.wanted[rest[k]] = witnesses[k].how;
    if (witnesses[k].how == Wanted::nominal) nominal[rest[k]] = Wanted::nominal;
  }
  std::vector<Arc> arcs;
  for (const SeenArc& arc : looked) arcs.push_back(arc.arc);
  const std::vector<SeenArc> again = look_along(round.seer, std::move(arcs), nominal, threads_);
  round.mark_covered(again);
  for (std::size_t a = 0; a < looked.size(); ++a)
    for (std::size_t k = 0; k < looked[a].seen.size(); ++k)
      looked[a].seen[k].insert(looked[a].seen[k].end(), again[a].seen[k].begin(),
                               again[a].seen[k].end());
  round.gap.wanted.assign(round.wanted.size(), Wanted::no);
  for (std::size_t k = 0; k < rest.size(); ++k) {
    if (round.covered[rest[k]] || witnesses[k].how == Wanted::no) continue;
    round.gap.wanted[rest[k]] = witnesses[k].how;
    round.gap.samples.push_back(rest[k]);
    round.gap.witnesses.push_back(witnesses[k]);
  }
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
  Round round(*this, settings_.seed);
  std::vector<SeenArc> looked = look_along(round.seer, std::move(arcs), round.wanted, threads_);
  judge(round, looked);
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
    all = trimmed(std::move(looked), round.samples.size(),
                  {settings_.spacing_m / 4, 3 * settings_.spacing_m});
  return all;
}

/// Samples that the plan was not made with show what it misses.
void Completion::further_rounds(std::vector<Arc>& arcs) {
  const double goal = settings_.sensor.kind == SensorKind::camera ? kCameraGoal : kGoal;
  for (int k = 1; k < kMostRounds; ++k) {
    Round round(*this, settings_.seed + static_cast<std::uint64_t>(k) * 1'000'003);
    std::vector<SeenArc> looked = look_along(round.seer, arcs, round.wanted, threads_);
    judge(round, looked);
    append(arcs, filling(round));
    const auto covered = static_cast<double>(round.count_covered());
    if (covered >= goal * (covered + static_cast<double>(round.gap.samples.size()))) return;
  }
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
    arcs = joined_ends(std::move(arcs), flyable_, {settings_.spacing_m, 30 * settings_.spacing_m});
  plan.planned.planned_m = sum_m(arcs);
  plan.arcs = in_frame(std::move(arcs), surface_.origin_m);
  for (std::size_t a = 0; a < plan.arcs.size(); ++a)
    plan.arcs[a].id.value = static_cast<std::uint32_t>(a);
  say_what_is_lost(plan.warnings);
}

}  // namespace arcbid
