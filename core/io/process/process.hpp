// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/base/error.hpp"
#include "core/base/ids.hpp"

namespace arcbid {

/// What every program of ours does the same way: its clock, how it is asked to stop, how it
/// reports.

/// The machine's monotonic clock: the same for all processes of one host.
TimeNs monotonic_ns();
/// CPU time of this thread, seconds: what other work on the machine does not count towards.
double thread_cpu_s();
/// Of all threads of this process.
double process_cpu_s();
/// Milliseconds of the wall clock at the start of a process: names the incarnation of an agent.
std::uint64_t birth_stamp_ms();

/// From now on SIGTERM and SIGINT ask the process to stop instead of ending it.
void stop_on_signals();
bool stop_requested();

/// The process ends (SIGTERM) when `parent`, the one that started it, does, however that ends; at
/// once if it has ended already.
void end_with_parent(int parent);

/// Tells whoever started this process what happens: a JSON object a line on standard output
/// ({"event": "agreed", "of": 3, …}; `of`: whose event it is, where it is an agent's) for a
/// launcher, or the same as words for a person.
class Reporter {
 public:
  Reporter(std::string who, bool json, std::optional<AgentId> of = std::nullopt)
      : who_(std::move(who)), json_(json), of_(of) {}
  void operator()(std::string_view event, nlohmann::json fields = nlohmann::json::object()) const;

 private:
  std::string who_;
  bool json_;
  std::optional<AgentId> of_;
};

/// Runs `body`; turns InputError into one line each on standard error and exit code 2, RunError and
/// anything unforeseen into one line and exit code 1.
int run_program(const std::function<Exit()>& body);

}  // namespace arcbid
