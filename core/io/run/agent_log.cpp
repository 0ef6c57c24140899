// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/agent_log.hpp"

#include <unistd.h>

#include <utility>

#include "core/base/error.hpp"
#include "core/io/build/build.hpp"

namespace arcbid {

AgentLog::AgentLog(const std::optional<std::filesystem::path>& file, const Life& life,
                   std::function<void(const std::string&)> warn)
    : warn_(std::move(warn)) {
  if (!file) return;
  log_.emplace(*file);
  log_->meta("schema", RunLog::schema);
  log_->meta("process", {{"role", "agent"},
                         {"agent", life.agent.value},
                         {"incarnation", life.incarnation},
                         {"pid", getpid()}});
  log_->meta("build", {{"version", build_version()}, {"commit", build_commit()}});
  log_->meta("seed", life.seed);
  commit();
}

void AgentLog::guarded(const std::function<void(RunLog&)>& act) {
  if (!log_) return;
  try {
    act(*log_);
  } catch (const RunError& error) {
    log_.reset();
    warn_(error.what());
  }
}

template <class Record>
void AgentLog::append(TimeNs now_ns, std::string_view name, int& kind, const Record& record) {
  if (!log_) return;
  if (kind == 0) kind = log_->kind(cdr_kind<Record>(name));
  log_->append(now_ns, kind, encode(record));
}

void AgentLog::birth(TimeNs now_ns, const Birth& birth, const Mission& mission) {
  append(now_ns, log_kind::mission, mission_, mission);
  append(now_ns, log_kind::birth, birth_, birth);
  commit();  // there is time now, and the auction is not to wait for so much to be written
}

void AgentLog::step(TimeNs now_ns, const Step& step) {
  append(now_ns, log_kind::step, step_, step);
}

void AgentLog::route(TimeNs now_ns, const PlannedRoute& route) {
  append(now_ns, log_kind::route, route_, route);
}

void AgentLog::fate(TimeNs now_ns, const Header& header, const std::vector<TimeNs>& arrivals_ns) {
  if (arrivals_ns.size() == 1 && arrivals_ns.front() <= now_ns) return;
  nlohmann::json body{{"sender", header.sender.value},
                      {"incarnation", header.incarnation},
                      {"sequence", header.sequence}};
  if (arrivals_ns.empty()) return write(now_ns, log_kind::lost, body);
  for (const TimeNs at_ns : arrivals_ns) body["after_ns"].push_back(at_ns - now_ns);
  write(now_ns, log_kind::fate, body);
}

void AgentLog::write(TimeNs now_ns, std::string_view kind, const nlohmann::json& body) {
  if (log_) log_->append(now_ns, kind, body);
}

std::optional<TimeNs> AgentLog::due_ns() const {
  return log_ ? log_->due_ns() : std::nullopt;
}

void AgentLog::commit_if_due(TimeNs now_ns) {
  guarded([&](RunLog& log) { log.commit_if_due(now_ns); });
}

void AgentLog::commit() {
  guarded([](RunLog& log) { log.commit(); });
}

}  // namespace arcbid
