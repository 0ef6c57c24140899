// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "sim/export/run_steps.hpp"

namespace arcbid {

/// A task that an agent says it takes.
struct StatedClaim {
  TaskId task;
  double bid = 0;
  std::optional<std::size_t> position;  ///< in the path, from 0
};

/// What an agent states about itself, each statement once: a decision that changed nothing and a
/// bid that is sent again say what was said before.
class Statements {
 public:
  /// The claims of what the step states anew; nothing: it states nothing.
  std::optional<std::vector<StatedClaim>> stated_in(const RunStep& at);

 private:
  struct Said {
    StatementKey key;
    std::vector<PathStop> path;
  };
  std::map<const LifeLog*, Said> said_;
};

/// What became of the auction in a step, for people: "started", "died", "returned", "agreed",
/// "reopened", and the particulars.
struct Happening {
  std::string_view what;
  std::string detail;
};
std::vector<Happening> happenings(const Update& update);

}  // namespace arcbid
