// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/recorded_messages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/run/log_files.hpp"

namespace arcbid {

RecordedMessages::RecordedMessages(const std::filesystem::path& run) {
  for (const auto& file : agents_logs(run)) {
    try {
      read(file);
    } catch (const InputError& error) {
      fmt::print(stderr, "left out: {}\n", error.what());
    }
  }
  if (logs_.empty())
    throw InputError(fmt::format("{}: no agent's log has the mission", (run / "logs").string()));
  std::sort(steps_.begin(), steps_.end());
}

void RecordedMessages::read(const std::filesystem::path& file) {
  auto log = std::make_unique<RunLogReader>(file);
  const auto mission = log->first(log_kind::mission);
  if (!mission) return;  // this life had nothing to say about it
  mission_ = decode<Mission>(mission->body);
  const std::size_t number = logs_.size();
  try {
    log->read(
        [&](const RunLogReader::Record& record) {
          steps_.push_back({record.t_ns, number, record.seq});
          return true;
        },
        0, log_kind::step);
  } catch (const InputError& damage) {
    fmt::print(stderr, "{}\n", damage.what());
  }
  logs_.push_back(std::move(log));
}

std::vector<AgentId> RecordedMessages::fleet() const {
  std::vector<AgentId> out;
  for (const Uav& uav : mission_.fleet) out.push_back(uav.id);
  return out;
}

void RecordedMessages::play(
    const std::function<bool(TimeNs t_ns, const AgentMessage& message)>& take) const {
  for (const Place& place : steps_) {
    Update update;
    logs_[place.log]->read(
        [&](const RunLogReader::Record& record) {
          update = decode<Step>(record.body).update;
          return false;
        },
        place.seq, log_kind::step);
    std::vector<AgentMessage> said;
    for (auto& bid : update.bids) said.emplace_back(std::move(bid));
    for (auto& relay : update.relays) said.emplace_back(std::move(relay));
    for (auto& status : update.statuses) said.emplace_back(std::move(status));
    for (const AgentMessage& message : said)
      if (!take(place.t_ns, message)) return;
  }
}

}  // namespace arcbid
