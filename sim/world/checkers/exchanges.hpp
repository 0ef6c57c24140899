// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "core/route/share.hpp"
#include "sim/world/checkers/arcs.hpp"

namespace arcbid {

/// What those who proved one agreement make of it: whatever was won is flown by exactly one of
/// them, nothing else is, nobody is over its limits, and two who work it out by themselves come to
/// the same.
class ExchangeChecker {
 public:
  /// The mission's pieces as the checkers cut them. All must outlive this.
  ExchangeChecker(const Mission& mission, const std::vector<Stretch>& pieces,
                  const Transit& transit, Findings& findings)
      : mission_(mission), pieces_(pieces), transit_(transit), findings_(findings) {}

  /// Whether what comes of this agreement is still to be worked out: twice for each.
  bool wants(const Agreement& proof) const;
  void after(TimeNs now_ns, const Agreement& proof, const FleetShare& share);
  /// The slowest flight of all against that of what was won, seconds.
  void compare(TimeNs now_ns, double won_s, double flown_s);

 private:
  void check_owners(TimeNs now_ns, const Agreement& proof, const FleetShare& share);
  void check_limits(TimeNs now_ns, const FleetShare& share);

  const Mission& mission_;
  const std::vector<Stretch>& pieces_;
  const Transit& transit_;
  Findings& findings_;
  struct WorkedOut {
    std::vector<std::vector<PathStop>> paths;
    int times = 0;
  };
  std::map<std::uint64_t, WorkedOut> worked_out_;  // by view hash
};

}  // namespace arcbid
