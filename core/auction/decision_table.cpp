// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/decision_table.hpp"

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

std::string_view name(Who who) {
  constexpr std::array<std::string_view, 5> names{"i", "k", "m", "n", "none"};
  return names[static_cast<std::size_t>(who)];
}

namespace {

constexpr std::size_t kinds = 5;

constexpr std::size_t pair(Who sender, Who receiver) {
  return static_cast<std::size_t>(sender) * kinds + static_cast<std::size_t>(receiver);
}

/// Where the row of each pair stands, from 1; 0: there is none.
constexpr auto row_numbers = [] {
  std::array<std::uint8_t, kinds * kinds> numbers{};
  for (std::size_t r = 0; r < decision_table.size(); ++r)
    numbers[pair(decision_table[r].sender, decision_table[r].receiver)] =
        static_cast<std::uint8_t>(r + 1);
  return numbers;
}();

}  // namespace

const Row& row(Who sender, Who receiver) {
  const std::size_t number = row_numbers[pair(sender, receiver)];
  check(number > 0, "every pair of beliefs has a row");
  return decision_table[number - 1];
}

Action decide(const Row& row, std::uint8_t holds) {
  for (const Clause& clause : row.clauses) {
    // An unused clause says "leave" under no condition, which is the default anyway.
    if ((clause.conditions & holds) == clause.conditions) return clause.action;
  }
  return Action::leave;
}

}  // namespace arcbid
