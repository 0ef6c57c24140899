// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/world/checkers/arcs.hpp"

namespace arcbid {

bool carries(const Uav& uav, Payload needed);
/// A tour of so many seconds; rounding is no reason to call one too long.
bool lasts(const Uav& uav, double tour_s);

/// What a proof of agreement says of payload and endurance must be so: nobody flies what it does
/// not carry the payload for, or longer than it lasts; every task without an owner has a reason,
/// and the reason holds; and whoever proves has no room, no payload or no endurance for it.
class LimitsChecker {
 public:
  /// All must outlive the checker; `pieces` may still get their places.
  LimitsChecker(const Mission& mission, const std::vector<Stretch>& pieces, const Transit& transit,
                Findings& findings)
      : mission_(mission), pieces_(pieces), transit_(transit), findings_(findings) {}

  void after(const SeenStep& step);

 private:
  const Uav& uav(AgentId agent) const;
  Payload needs(std::size_t task) const;
  bool can_add(const Uav& uav, const std::vector<PathStop>& path, std::size_t task) const;
  NoBidderReason reason(const Agreement& proof, std::size_t task) const;
  void check_own(const SeenStep& step) const;
  void check_task(const SeenStep& step, std::size_t task) const;

  const Mission& mission_;
  const std::vector<Stretch>& pieces_;
  const Transit& transit_;
  Findings& findings_;
};

}  // namespace arcbid
