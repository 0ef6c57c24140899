// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/recorded_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/arcs/mission_misfit.hpp"
#include "core/auction/roster.hpp"
#include "core/auction/validation.hpp"
#include "core/base/error.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/run/log_files.hpp"

namespace arcbid {

namespace {

using Path = std::filesystem::path;

std::vector<AgentMessage> said_in(Step step) {
  std::vector<AgentMessage> said;
  for (auto& bid : step.update.bids) said.emplace_back(std::move(bid));
  for (auto& relay : step.update.relays) said.emplace_back(std::move(relay));
  for (auto& status : step.update.statuses) said.emplace_back(std::move(status));
  return said;
}

/// What an agent of the mission can have said: a record that still reads may be damaged.
class Sayable {
 public:
  /// `named`: by which digests the fleet spoke of the mission. Another build's may be others.
  Sayable(const Mission& mission, const Header& named) : view_(roster_of(mission)) {
    const AuctionSettings& auction = mission.auction;
    const TaskSet tasks = split(mission.arcs, auction.split_m, auction.max_tasks);
    expected_ = {named.mission_digest, named.task_digest,   tasks.tasks.size(), AgentId{},
                 auction.policy,       auction.bundle_limit};
  }
  std::optional<std::string> refusal(const AgentMessage& message) const {
    return std::visit(
        [this](const auto& said) {
          const auto reason = arcbid::refusal(said.header, expected_, view_);
          return reason ? reason : refusal_of(said);
        },
        message);
  }

 private:
  std::optional<std::string> refusal_of(const BidMessage& bid) const {
    if (bid.statement.agent != bid.header.sender) return "a bid in another agent's name";
    return arcbid::refusal(bid.statement, expected_, view_);
  }
  std::optional<std::string> refusal_of(const RelayMessage& relay) const {
    return arcbid::refusal(relay.statement, expected_, view_);
  }
  std::optional<std::string> refusal_of(const StatusMessage& status) const {
    return arcbid::refusal(status, view_);
  }

  View view_;
  Expected expected_;
};

Header header_of(const AgentMessage& message) {
  return std::visit([](const auto& said) { return said.header; }, message);
}

/// What of one log can be said again.
class Scan {
 public:
  std::optional<Mission> mission;
  std::vector<std::pair<TimeNs, std::int64_t>> steps;  // when, and which record
  std::string first_lost;
  std::size_t lost = 0;

  Scan(const RunLogReader& log, const LogSchemas& schemas) : schemas_(schemas) {
    log.read_intact(
        [this](const RunLogReader::Record& record) {
          try {
            take(record);
          } catch (const InputError& error) {
            lose(record.seq, error.what());
          }
          return true;
        },
        [this](const RunLogReader::Lost& gap) { lose(gap.from_seq, gap.why); });
  }
  /// Somebody who had the mission has spoken.
  bool has_spoken() const { return sayable_.has_value(); }

 private:
  void take(const RunLogReader::Record& record) {
    if (record.kind == log_kind::mission) take(schemas_.decode<Mission>(record));
    if (record.kind != log_kind::step) return;
    if (!mission) throw InputError("a step before its mission");
    const auto said = said_in(schemas_.decode<Step>(record));
    if (!said.empty() && !sayable_) trust_mission(header_of(said.front()));
    for (const AgentMessage& message : said)
      if (const auto reason = sayable_->refusal(message)) throw InputError(*reason);
    steps.emplace_back(record.t_ns, record.seq);
  }
  void take(Mission read) {
    if (const auto problem = misfit(read)) throw InputError(fmt::format("mission: {}", *problem));
    mission = std::move(read);
  }
  /// A mission that is damaged may well be one still, but not the one that the agent spoke of.
  void trust_mission(const Header& named) {
    if (!schemas_.other() && named.mission_digest != digest(*mission))
      throw InputError(fmt::format("its messages name mission {:016x}, its record holds {:016x}",
                                   named.mission_digest, digest(*mission)));
    sayable_.emplace(*mission, named);
  }
  void lose(std::int64_t seq, const std::string& why) {
    if (lost++ == 0) first_lost = fmt::format("record {}: {}", seq, why);
  }

  const LogSchemas& schemas_;
  std::optional<Sayable> sayable_;
};

}  // namespace

RecordedMessages::RecordedMessages(const Path& run) {
  for (const Path& file : agents_logs(run)) read(file);
  if (logs_.empty())
    throw InputError(fmt::format(
        "{}: no agent's log has the mission and a message{}{}", (run / "logs").string(),
        left_out_.empty() ? "" : "; the first one: ", left_out_.empty() ? "" : left_out_.front()));
  std::sort(steps_.begin(), steps_.end());
}

void RecordedMessages::read(const Path& file) {
  std::optional<Log> log;
  std::optional<Scan> scan;
  try {
    auto reader = std::make_unique<RunLogReader>(file);
    LogSchemas schemas(*reader);
    schemas.demand_read();
    log.emplace(Log{std::move(reader), std::move(schemas)});
    scan.emplace(*log->reader, log->schemas);
  } catch (const InputError& error) {
    left_out_.emplace_back(error.what());
    return;
  }
  if (scan->lost > 0)
    left_out_.push_back(
        fmt::format("{}: {}{}", file.string(), scan->first_lost,
                    scan->lost > 1 ? fmt::format("; and {} more", scan->lost - 1) : ""));
  if (!scan->has_spoken()) return;
  if (!logs_.empty() && digest(*scan->mission) != digest(mission_))
    throw InputError(fmt::format("{}: mission {:016x}, but the other logs have {:016x}",
                                 file.string(), digest(*scan->mission), digest(mission_)));
  mission_ = std::move(*scan->mission);
  for (const auto& [t_ns, seq] : scan->steps) steps_.push_back({t_ns, logs_.size(), seq});
  if (const auto& other = log->schemas.other()) others_[*other].push_back(file.filename().string());
  logs_.push_back(std::move(*log));
}

std::vector<std::string> RecordedMessages::of_other_builds() const {
  return lines_about(others_, "agents of this build may refuse its messages");
}

std::vector<AgentId> RecordedMessages::fleet() const {
  return roster_of(mission_);
}

void RecordedMessages::play(
    const std::function<bool(TimeNs t_ns, const AgentMessage& message)>& take) const {
  for (const Place& place : steps_) {
    std::vector<AgentMessage> said;
    const Log& log = logs_[place.log];
    log.reader->read_intact(
        [&](const RunLogReader::Record& record) {
          if (record.seq == place.seq) said = said_in(log.schemas.decode<Step>(record));
          return false;
        },
        [](const RunLogReader::Lost&) {}, place.seq);
    for (const AgentMessage& message : said)
      if (!take(place.t_ns, message)) return;
  }
}

}  // namespace arcbid
