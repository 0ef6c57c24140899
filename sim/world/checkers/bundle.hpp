// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "sim/world/checkers/step.hpp"

namespace arcbid {

/// Bundle b_i and path p_i of every decision: the same tasks in both, none twice, no more than L_t;
/// warped bids never rise along the bundle. Where bundles are kept (claims-keep) a release takes
/// exactly the first task that was outbid and what came after it.
class BundleChecker {
 public:
  BundleChecker(const Mission& mission, Findings& findings);

  void after(const SeenStep& step);

 private:
  void check_path(const SeenStep& step, std::vector<std::uint32_t> held) const;
  void check_bids(const SeenStep& step, const std::vector<Claim>& bundle) const;
  void check_cascade(const SeenStep& step, const std::vector<Claim>& before,
                     const std::vector<Claim>& after) const;

  PolicyKind policy_;
  bool warped_;
  std::size_t limit_;
  Findings& findings_;
  std::map<std::uint32_t, std::vector<Claim>> bundles_;  // by life
};

}  // namespace arcbid
