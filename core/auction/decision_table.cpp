// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/decision_table.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace arcbid {

std::string_view name(Action action) {
  switch (action) {
    case Action::leave:
      return "leave";
    case Action::update:
      return "update";
    case Action::reset:
      return "reset";
  }
  return "?";
}

const Row& row(Who sender, Who receiver) {
  const auto found = std::find_if(decision_table.begin(), decision_table.end(), [&](const Row& r) {
    return r.sender == sender && r.receiver == receiver;
  });
  check(found != decision_table.end(), "every pair of beliefs has a row");
  return *found;
}

Action decide(const Row& row, std::uint8_t holds) {
  for (const Clause& clause : row.clauses) {
    // An unused clause says "leave" under no condition, which is the default anyway.
    if ((clause.conditions & holds) == clause.conditions) return clause.action;
  }
  return Action::leave;
}

}  // namespace arcbid
