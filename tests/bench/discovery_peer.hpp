// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/ids.hpp"

namespace arcbid::bench {

enum class Meeting {
  everybody,    ///< each process announces itself to all ports of the domain
  those_below,  ///< only to the ports below its own: each pair still meets once
  server,       ///< only to a discovery server
};

/// How the processes of a fleet find each other and what they open.
struct Way {
  const char* name;
  Meeting meeting = Meeting::everybody;
  bool two_topics = false;        ///< 2 writers and 2 readers in place of an agent's 4 and 5
  bool static_endpoints = false;  ///< known from a file that all have; needs `two_topics`
  std::uint32_t agents_per_process = 1;
};

struct Fleet {
  std::uint32_t domain = 0;
  std::uint32_t agents = 0;
  std::uint32_t agents_per_process = 1;

  std::uint32_t processes() const { return (agents + agents_per_process - 1) / agents_per_process; }
};

/// Joins as process `index` (0..processes - 1): a participant with its endpoints, which never
/// speak. True as soon as every other process's writer and reader of the first topic are matched;
/// false when `limit_ns` of the monotonic clock comes first. The participant stays until the
/// process ends, for the others need it: once a process. Throws RunError when Fast DDS refuses it.
bool meet_all(const Way& way, const Fleet& fleet, std::uint32_t index, TimeNs limit_ns);

/// What `fast-discovery-server -i 0` runs; it stays until the process ends. Throws RunError.
void start_discovery_server(const Fleet& fleet);

}  // namespace arcbid::bench
