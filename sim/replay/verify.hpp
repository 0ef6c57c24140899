// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/replay/run_archive.hpp"

namespace arcbid {

/// Where a life, replayed, does something else than its log says.
struct Divergence {
  AgentId agent;
  std::int64_t record = 0;
  TimeNs t_ns = 0;
  std::uint32_t round = 0;
  std::optional<ArcId> arc;  ///< when it is about a task
  std::string what;          ///< the field, and its value in the log and in the replay
};

struct LifeVerdict {
  std::size_t steps = 0;         ///< replayed with the same outcome, bit for bit
  std::size_t routes = 0;        ///< likewise
  std::size_t beyond_proof = 0;  ///< steps behind a gap in the log: on record, but not replayed
  std::optional<Divergence> divergence;
};

/// Feeds the agent's state machine what its log says it consumed, and demands what it says it
/// produced: decisions, bundles, paths, y, z, messages, proofs, and the tours planned from them. A
/// log that ends early or is damaged is held to what is on record before the damage. Throws
/// InputError, one line, for a log of another schema.
LifeVerdict verify(const LifeLog& life);

/// One line: agent, round, arc, both values.
std::string describe(const Divergence& divergence);

}  // namespace arcbid
