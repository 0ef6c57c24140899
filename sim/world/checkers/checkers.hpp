// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/world/checkers/bundle.hpp"
#include "sim/world/checkers/limits.hpp"
#include "sim/world/checkers/proof.hpp"
#include "sim/world/checkers/statements.hpp"

namespace arcbid {

/// All that is checked after every step.
struct Checkers {
  /// All must outlive the checkers.
  Checkers(const Mission& mission, const std::vector<Stretch>& pieces, const Transit& transit)
      : statements(pieces.size(), findings),
        bundle(mission, findings),
        proof(mission, pieces.size(), findings),
        limits(mission, pieces, transit, findings),
        stability(findings) {}
  Checkers(const Checkers&) = delete;
  Checkers& operator=(const Checkers&) = delete;

  void after(const SeenStep& step) {
    statements.after(step);
    bundle.after(step);
    proof.after(step);
    limits.after(step);
    stability.after(step);
  }

  Findings findings;
  StatementChecker statements;
  BundleChecker bundle;
  ProofChecker proof;
  LimitsChecker limits;
  StabilityChecker stability;
};

}  // namespace arcbid
