// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/coverage/gaps.hpp"
#include "core/coverage/outlook.hpp"
#include "core/coverage/trim.hpp"
#include "core/coverage/visibility.hpp"
#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// Samples drawn with one seed, and how arcs do on them.
struct Round {
  Samples samples;
  Seer seer;
  Visibility visibility;
  std::vector<Wanted> wanted;
  std::vector<bool> tried;    ///< whether it is found out if they can be seen
  std::vector<bool> covered;  ///< from some arc
  Gap gap;

  /// Keeps references to the first three.
  Round(const Scene& scene, const Surface& surface, const Flyable& flyable, const Outlook& outlook,
        const CoverageSettings& settings, unsigned threads, std::uint64_t seed);
  Round(const Round&) = delete;
  Round& operator=(const Round&) = delete;

  void mark_covered(const std::vector<SeenArc>& looked);
  void mark_covered(const std::vector<bool>& seen);
  std::size_t count_covered() const;
  /// What is wanted of the samples that `but` leaves.
  std::vector<Wanted> wanted_without(const std::vector<bool>& but) const;

  /// Of what is not covered: what can be seen, and by which sensor. Gives what only the nominal one
  /// can see, which is then to be asked of the arcs too. Tells the outlook what was found.
  std::vector<Wanted> judge(Outlook& outlook, unsigned threads);
  /// The gap is what can be seen and yet is not covered. After judge.
  void find_gap();

 private:
  void search_rim(const Outlook& outlook, unsigned threads);
};

}  // namespace arcbid
