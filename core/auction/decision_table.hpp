// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/ids.hpp"

namespace arcbid {

/// The consensus rules of CBBA (Choi, Brunet, How 2009, Table I) as data. Receiver i hears from
/// sender k about one task; m and n are other agents, m the first of them in the row.

/// Whom an agent believes to be the winner.
enum class Who : std::uint8_t { i, k, m, n, none };

/// Whom the sender (z_kj) and the receiver (z_ij) of a message believe to be the winner.
struct Believed {
  Who sender, receiver;
};
inline Believed believed(AgentId i, AgentId k, std::optional<AgentId> z_kj,
                         std::optional<AgentId> z_ij) {
  const auto who = [i, k](std::optional<AgentId> winner) {
    if (!winner) return Who::none;
    return *winner == i ? Who::i : *winner == k ? Who::k : Who::m;
  };
  const Who sender = who(z_kj), receiver = who(z_ij);
  const bool differ = sender == Who::m && receiver == Who::m && z_kj != z_ij;
  return {sender, differ ? Who::n : receiver};
}

enum class Action : std::uint8_t {
  leave,   ///< keep z_ij, y_ij
  update,  ///< z_ij = z_kj, y_ij = y_kj
  reset    ///< z_ij = none, y_ij = 0
};
std::string_view name(Action action);
std::string_view name(Who who);

/// What a clause may ask. All that are set must hold.
enum Condition : std::uint8_t {
  always = 0,
  newer_m = 1,          ///< s_km > s_im: the sender has later news of m
  newer_or_same_m = 2,  ///< s_km >= s_im
  older_m = 4,          ///< s_im > s_km
  newer_n = 8,          ///< s_kn > s_in
  higher_bid = 16       ///< y_kj > y_ij, or equal and z_kj the lower id
};

struct Clause {
  std::uint8_t conditions = always;
  Action action = Action::leave;
};

/// One row: the first clause whose conditions hold decides; where none does, leave.
struct Row {
  int number;
  Who sender;    ///< z_kj
  Who receiver;  ///< z_ij
  std::array<Clause, 3> clauses;
};

/// Row 12 has the >= of the MIT code (first clause): read strictly, the published table comes to
/// rest in disagreement on one benchmark instance. docs/ARCHITECTURE.md says more.
inline constexpr std::array<Row, 17> decision_table{{
    {1, Who::k, Who::i, {{{higher_bid, Action::update}}}},
    {2, Who::k, Who::k, {{{always, Action::update}}}},
    {3, Who::k, Who::m, {{{newer_m, Action::update}, {higher_bid, Action::update}}}},
    {4, Who::k, Who::none, {{{always, Action::update}}}},
    {5, Who::i, Who::i, {}},
    {6, Who::i, Who::k, {{{always, Action::reset}}}},
    {7, Who::i, Who::m, {{{newer_m, Action::reset}}}},
    {8, Who::i, Who::none, {}},
    {9, Who::m, Who::i, {{{newer_m | higher_bid, Action::update}}}},
    {10, Who::m, Who::k, {{{newer_m, Action::update}, {always, Action::reset}}}},
    {11, Who::m, Who::m, {{{newer_m, Action::update}}}},
    {12,
     Who::m,
     Who::n,
     {{{newer_or_same_m | newer_n, Action::update},
       {newer_m | higher_bid, Action::update},
       {newer_n | older_m, Action::reset}}}},
    {13, Who::m, Who::none, {{{newer_m, Action::update}}}},
    {14, Who::none, Who::i, {}},
    {15, Who::none, Who::k, {{{always, Action::update}}}},
    {16, Who::none, Who::m, {{{newer_m, Action::update}}}},
    {17, Who::none, Who::none, {}},
}};

/// The row for a pair of beliefs. Every legal pair has exactly one: a lone other agent is m, and n
/// appears only as the receiver's belief beside another m.
const Row& row(Who sender, Who receiver);

/// What the row says when `holds` are the conditions that hold.
Action decide(const Row& row, std::uint8_t holds);

}  // namespace arcbid
