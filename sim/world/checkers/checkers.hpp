// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/world/checkers/bundle.hpp"
#include "sim/world/checkers/proof.hpp"
#include "sim/world/checkers/statements.hpp"

namespace arcbid {

/// All that is checked after every step.
struct Checkers {
  Checkers(const Mission& mission, std::size_t tasks)
      : statements(tasks, findings),
        bundle(mission, findings),
        proof(mission, tasks, findings),
        stability(findings) {}
  Checkers(const Checkers&) = delete;
  Checkers& operator=(const Checkers&) = delete;

  void after(const SeenStep& step) {
    statements.after(step);
    bundle.after(step);
    proof.after(step);
    stability.after(step);
  }

  Findings findings;
  StatementChecker statements;
  BundleChecker bundle;
  ProofChecker proof;
  StabilityChecker stability;
};

}  // namespace arcbid
