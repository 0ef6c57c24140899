// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/coverage/round.hpp"

#include <algorithm>
#include <cmath>

namespace arcbid {

namespace {

constexpr double kSample_m = 0.3;  // or less where a small stand-off shows more of the surface
constexpr double kLeastSample_m = 0.1, kLeastShare = 0.05;  // the latter of a tiny one's extent
constexpr double kFew = 20'000;      // samples; of a small structure each would stand for too much
constexpr std::uint32_t kDoubt = 8;  // of so many samples that seem hopeless one is tried

double extent_m(const Surface& surface) {
  double half_m = 0;
  for (const Vec3& p : surface.points) half_m = std::max(half_m, p.cwiseAbs().maxCoeff());
  return 2 * half_m;
}

Samples enough_samples(const Surface& surface, const CoverageSettings& settings,
                       std::uint64_t seed) {
  const double spacing_m = std::min(kSample_m, settings.sensor.range_m / 8);
  Samples samples = sided_samples(surface, spacing_m, seed);
  const double share = static_cast<double>(samples.size()) / kFew;
  const double finer_m = std::max(std::min(kLeastSample_m, kLeastShare * extent_m(surface)),
                                  spacing_m * std::sqrt(share));
  return finer_m < spacing_m ? sided_samples(surface, finer_m, seed) : samples;
}

}  // namespace

Round::Round(const Scene& scene, const Surface& surface, const Flyable& flyable,
             const Outlook& outlook, const CoverageSettings& settings, unsigned threads,
             std::uint64_t seed)
    : samples(enough_samples(surface, settings, seed)),
      seer(scene, surface, samples, settings.sensor),
      visibility(seer, flyable, settings.safety_m),
      wanted(samples.size(), Wanted::no),
      tried(samples.size()),
      covered(samples.size()) {
  for (std::uint32_t s = 0; s < samples.size(); ++s)
    tried[s] = s % kDoubt == 0 || !outlook.hopeless(samples.points[s], samples.normals[s]);
  const std::vector<bool> open = visibility.open(tried, threads);
  for (std::size_t s = 0; s < open.size(); ++s)
    if (open[s]) wanted[s] = Wanted::narrow;
}

void Round::mark_covered(const std::vector<SeenArc>& looked) {
  for (const SeenArc& arc : looked)
    for (const Seen& seen : arc.seen)
      for (const std::uint32_t s : seen) covered[s] = true;
}

void Round::mark_covered(const std::vector<bool>& seen) {
  for (std::size_t s = 0; s < seen.size(); ++s)
    if (seen[s]) covered[s] = true;
}

std::size_t Round::count_covered() const {
  return static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
}

std::vector<Wanted> Round::wanted_without(const std::vector<bool>& but) const {
  std::vector<Wanted> left = wanted;
  for (std::size_t s = 0; s < left.size(); ++s)
    if (but[s]) left[s] = Wanted::no;
  return left;
}

/// Next to what can be seen the places to see from are few: there a second, finer search pays.
void Round::search_rim(const Outlook& outlook, unsigned threads) {
  Seen rim;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < gap.samples.size(); ++k) {
    const std::uint32_t s = gap.samples[k];
    if (gap.witnesses[k].how != Wanted::no || !outlook.mixed(samples.points[s], samples.normals[s]))
      continue;
    rim.push_back(s);
    number.push_back(k);
  }
  const auto found = visibility.rim_witnesses(rim, threads);
  for (std::size_t r = 0; r < rim.size(); ++r) {
    gap.witnesses[number[r]] = found[r];
    wanted[rim[r]] = found[r].how;
  }
}

std::vector<Wanted> Round::judge(Outlook& outlook, unsigned threads) {
  for (std::uint32_t s = 0; s < covered.size(); ++s)
    if (wanted[s] != Wanted::no && !covered[s]) gap.samples.push_back(s);
  gap.witnesses = visibility.witnesses(gap.samples, threads);
  for (std::size_t k = 0; k < gap.samples.size(); ++k)
    wanted[gap.samples[k]] = gap.witnesses[k].how;
  for (std::size_t s = 0; s < wanted.size(); ++s)
    if (tried[s]) outlook.learn(samples.points[s], samples.normals[s], wanted[s] != Wanted::no);
  search_rim(outlook, threads);
  std::vector<Wanted> nominal(wanted.size(), Wanted::no);
  for (const std::uint32_t s : gap.samples)
    if (wanted[s] == Wanted::nominal) nominal[s] = Wanted::nominal;
  return nominal;
}

void Round::find_gap() {
  Gap left;
  left.wanted.assign(wanted.size(), Wanted::no);
  for (std::size_t k = 0; k < gap.samples.size(); ++k) {
    const std::uint32_t s = gap.samples[k];
    if (covered[s] || wanted[s] == Wanted::no) continue;
    left.wanted[s] = wanted[s];
    left.samples.push_back(s);
    left.witnesses.push_back(gap.witnesses[k]);
  }
  gap = std::move(left);
}

}  // namespace arcbid
