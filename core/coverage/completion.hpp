// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/coverage/round.hpp"
#include "core/coverage/trim.hpp"
#include "core/structure/bridge_arcs.hpp"

namespace arcbid {

/// Completes the arcs of bridge_arcs.
class Completion {
 public:
  /// `ground`: points that are in the way but not inspected; `ground_m`: z of the ground.
  Completion(const Structure& structure, const std::vector<Vec3>& ground, double ground_m,
             const CoverageSettings& settings);

  /// Replaces the plan's arcs and fills in what was planned.
  void run(ArcPlan& plan);

 private:
  void drop_unreachable(std::vector<Arc>& arcs);
  Round& new_round(std::uint64_t seed);
  std::vector<Arc> filling(const Round& round);
  std::vector<Arc> first_round(std::vector<Arc> arcs, PlannedCoverage& planned);
  void further_rounds(std::vector<Arc>& arcs);
  std::vector<Arc> without_spare_gaps(std::vector<Arc> arcs) const;
  void say_what_is_lost(std::vector<std::string>& warnings) const;

  const CoverageSettings& settings_;
  unsigned threads_;
  double floor_m_;  // z, in the structure's frame
  Surface surface_;
  Scene scene_;
  Flyable flyable_;
  Outlook outlook_;
  std::vector<std::unique_ptr<Round>> rounds_;
  std::size_t lost_views_ = 0;
  double unreachable_m_ = 0;
};

}  // namespace arcbid
