// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/agent_log.hpp"

#include <utility>

#include "core/base/error.hpp"
#include "core/io/run/event_json.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

constexpr TimeNs write_interval_ns = 80'000'000;

std::string_view kind_of(const Event& event) {
  return kind(event);
}
std::string_view kind_of(const DecisionMade&) {
  return "decision";
}
std::string_view kind_of(const Agreement&) {
  return "agreed";
}
std::string_view kind_of(const BidMessage&) {
  return "sent_bid";
}
std::string_view kind_of(const RelayMessage&) {
  return "sent_relay";
}
std::string_view kind_of(const StatusMessage&) {
  return "sent_status";
}

json body_of(const Event& event) {
  json body = to_json(event);
  body["now_ns"] = event.now_ns;
  return body;
}
json body_of(const auto& what) {
  return to_json(what);
}

}  // namespace

AgentLog::AgentLog(const std::optional<std::filesystem::path>& file,
                   std::function<void(const std::string&)> warn)
    : warn_(std::move(warn)) {
  if (file) log_.emplace(*file);
}

AgentLog::~AgentLog() {
  // Somebody may be on the way out because of an exception: whatever fails now must not end it all.
  try {
    commit();
  } catch (...) {
  }
}

void AgentLog::guarded(const std::function<void(RunLog&)>& act) {
  if (!log_) return;
  try {
    act(*log_);
  } catch (const RunError& error) {
    log_.reset();
    kept_.clear();
    warn_(error.what());
  }
}

void AgentLog::meta(std::string_view key, const json& value) {
  guarded([&](RunLog& log) { log.meta(key, value); });
}

void AgentLog::keep(TimeNs now_ns, Record what) {
  if (log_) kept_.push_back({now_ns, std::move(what)});
}

void AgentLog::write_kept() {
  for (const Kept& kept : std::exchange(kept_, {}))
    std::visit(
        [&](const auto& what) {
          guarded([&](RunLog& log) { log.append(kept.at_ns, kind_of(what), body_of(what)); });
        },
        kept.what);
}

void AgentLog::write(TimeNs now_ns, std::string_view kind, const json& body) {
  write_kept();
  guarded([&](RunLog& log) { log.append(now_ns, kind, body); });
}

std::optional<TimeNs> AgentLog::due_ns() const {
  if (kept_.empty()) return std::nullopt;
  return kept_.front().at_ns + write_interval_ns;
}

void AgentLog::write_if_due(TimeNs now_ns) {
  if (!kept_.empty() && now_ns < *due_ns()) return;
  write_kept();
  guarded([&](RunLog& log) { log.commit_if_due(now_ns); });
}

void AgentLog::commit() {
  write_kept();
  guarded([](RunLog& log) { log.commit(); });
}

}  // namespace arcbid
