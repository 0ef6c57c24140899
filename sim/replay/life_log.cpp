// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/life_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/arcs/mission_misfit.hpp"
#include "core/auction/task_set.hpp"
#include "core/base/error.hpp"
#include "core/io/run/agent_log.hpp"
#include "sim/replay/misfit.hpp"

namespace arcbid {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

/// Who has no mission yet asks for it under numbers of its own, which its core uses again.
std::optional<MessageId> heard_in(const Event& event) {
  return std::visit(Overloaded{[](const Tick&) -> std::optional<MessageId> { return {}; },
                               [](const RoutePublished&) -> std::optional<MessageId> { return {}; },
                               [](const auto& message) -> std::optional<MessageId> {
                                 const Header& h = message.header;
                                 if (h.mission_digest == 0) return {};
                                 return MessageId{h.sender, h.incarnation, h.sequence};
                               }},
                    event.what);
}

const Statement* statement_in(const Event& event) {
  if (const auto* bid = std::get_if<BidMessage>(&event.what)) return &bid->statement;
  if (const auto* relay = std::get_if<RelayMessage>(&event.what)) return &relay->statement;
  return nullptr;
}

}  // namespace

LifeLog::LifeLog(const std::filesystem::path& file)
    : reader_(std::make_unique<RunLogReader>(file)), schemas_(*reader_) {
  read_head();
  index();
}

void LifeLog::read_head() {
  const auto process = reader_->meta("process");
  const auto seed = reader_->meta("seed");
  if (!process.is_object() || !process.value("agent", nlohmann::json()).is_number_unsigned())
    throw InputError(
        fmt::format("{}: meta process: is not an agent's: {}", file().string(), process.dump()));
  agent_ = {process["agent"].get<std::uint32_t>()};
  incarnation_ = process.value("incarnation", std::uint64_t{0});
  pid_ = process.value("pid", std::uint64_t{0});
  seed_ = seed.is_number_unsigned() ? seed.get<std::uint64_t>() : 0;
  schemas_.demand_read();
}

void LifeLog::index() {
  Step room;
  reader_->read_intact(
      [&](const RunLogReader::Record& record) {
        try {
          take(record, room);
          last_ns_ = record.t_ns;
        } catch (const InputError& error) {
          lost({record.seq, record.seq, error.what()});
        }
        return true;
      },
      [this](const RunLogReader::Lost& what) { lost(what); });
  // A mission that is damaged may well be one still, but not the one that the agent spoke of.
  if (names_another_ && !names_mission_) throw InputError(*damage_);
}

void LifeLog::lost(const RunLogReader::Lost& lost) {
  if (damage_) return;
  damage_ = fmt::format("{}: records from {} on: {}", file().string(), lost.from_seq, lost.why);
  gap_ = marks_.size();
}

void LifeLog::take(const RunLogReader::Record& record, Step& room) {
  if (record.kind == log_kind::step) {
    if (!birth_ || !mission_)
      throw InputError(fmt::format("{}: a step before its birth", file().string()));
    schemas_.decode_into(room, record);
    if (const auto problem = misfit(room, *mission_, tasks_))
      throw InputError(fmt::format("{}: record {}: {}", file().string(), record.seq, *problem));
    mark(record, room);
  } else if (record.kind == log_kind::mission) {
    mission_ = std::make_shared<const Mission>(schemas_.decode<Mission>(record));
    mission_digest_ = digest(*mission_);
    born_ns_ = record.t_ns;
    learnt_.resize(mission_->fleet.size());
    if (const auto problem = misfit(*mission_)) {
      mission_ = nullptr;
      throw InputError(fmt::format("{}: record {}: {}", file().string(), record.seq, *problem));
    }
    const AuctionSettings& auction = mission_->auction;
    tasks_ = split(mission_->arcs, auction.split_m, auction.max_tasks).tasks.size();
    if (position(agent_) == mission_->fleet.size())
      throw InputError(
          fmt::format("{}: agent {} is not of its mission's fleet", file().string(), agent_.value));
  } else if (record.kind == log_kind::birth) {
    const Birth birth = schemas_.decode<Birth>(record);
    if (birth.agent != agent_ || birth.incarnation == 0)
      throw InputError(
          fmt::format("{}: holds the birth of agent {}, life {}; legal: agent {}, "
                      "any life above 0",
                      file().string(), birth.agent.value, birth.incarnation, agent_.value));
    birth_ = birth;
  } else if (record.kind == log_kind::end) {
    const auto body = nlohmann::json::parse(record.body, nullptr, false);
    if (body.is_object() && body.contains("by") && body["by"].is_string()) ended_by_ = body["by"];
  }
}

std::size_t LifeLog::position(AgentId agent) const {
  const auto at = std::find_if(mission_->fleet.begin(), mission_->fleet.end(),
                               [agent](const Uav& uav) { return uav.id == agent; });
  return static_cast<std::size_t>(at - mission_->fleet.begin());
}

void LifeLog::mark(const RunLogReader::Record& record, const Step& step) {
  const Update& update = step.update;
  Mark mark;
  mark.seq = record.seq;
  mark.t_ns = record.t_ns;
  mark.event = static_cast<std::uint8_t>(step.event.what.index());
  mark.refused = update.refused.has_value();
  mark.decided = update.decision.has_value();
  mark.changed = update.decision && update.decision->changed;
  mark.started = update.started;
  mark.lost = update.agreement_lost;
  mark.agreed = update.agreed.has_value();
  mark.died = !update.died.empty();
  mark.returned = !update.returned.empty();
  if (update.decision) round_ = update.decision->round;
  mark.round = round_;
  mark.heard = heard_in(step.event);
  mark.sent = update.bids.size() + update.relays.size() + update.statuses.size();
  mark.first_sent = UINT64_MAX;
  const auto note = [&](const auto& messages) {
    for (const auto& message : messages) {
      mark.first_sent = std::min(mark.first_sent, message.header.sequence);
      expect_mission(message.header.mission_digest);
    }
  };
  note(update.bids), note(update.relays), note(update.statuses);
  marks_.push_back(mark);
  if (const Statement* heard = statement_in(step.event); heard && !update.refused)
    learn(*heard, false);
  for (const AgentId dead : update.died) bury(dead);
  if (update.decision) learn({agent_, update.decision->key, update.decision->body}, true);
  for (const BidMessage& bid : update.bids) learn(bid.statement, true);
}

/// The digest of a mission that another build laid out is that build's secret.
void LifeLog::expect_mission(std::uint64_t named) {
  if (schemas_.other()) return;
  (named == mission_digest_ ? names_mission_ : names_another_) = true;
  if (named != mission_digest_)
    throw InputError(fmt::format("{}: its messages name mission {:016x}, its record holds {:016x}",
                                 file().string(), named, mission_digest_));
}

/// As View::merge does: what is newer is held.
void LifeLog::learn(const Statement& statement, bool is_own) {
  const std::size_t member = position(statement.agent);
  if (member >= learnt_.size() || (!is_own && statement.agent == agent_)) return;
  std::vector<Learnt>& held = learnt_[member];
  if (!held.empty() && statement.key <= held.back().key) return;
  held.push_back({marks_.size() - 1, statement.key, is_own});
  marks_.back().learnt = true;
}

void LifeLog::bury(AgentId agent) {
  const std::size_t member = position(agent);
  if (member >= learnt_.size()) return;
  StatementKey key = learnt_[member].empty() ? StatementKey{} : learnt_[member].back().key;
  if (key.dead) return;  // a tombstone that was heard of
  key.dead = true;
  learnt_[member].push_back({marks_.size() - 1, key, false});
  marks_.back().learnt = true;
}

Step LifeLog::step(std::size_t mark) const {
  std::optional<Step> found;
  reader_->read(
      [&](const RunLogReader::Record& record) {
        found = schemas_.decode<Step>(record);
        return false;
      },
      marks_.at(mark).seq);
  if (!found)
    throw InputError(fmt::format("{}: record {} is gone", file().string(), marks_[mark].seq));
  return std::move(*found);
}

void LifeLog::steps(
    const std::function<bool(std::size_t mark, Step step, std::string_view bytes)>& take,
    std::size_t from) const {
  if (from >= marks_.size()) return;
  std::size_t at = from;
  reader_->read_intact(
      [&](const RunLogReader::Record& record) {
        if (record.seq != marks_[at].seq) return true;
        const std::size_t mark = at++;
        return take(mark, schemas_.decode<Step>(record), record.body) && at < marks_.size();
      },
      [](const RunLogReader::Lost&) {}, marks_[from].seq);
}

std::vector<PlannedRoute> LifeLog::routes() const {
  std::vector<PlannedRoute> out;
  const auto take = [&](const RunLogReader::Record& record) {
    if (record.kind == log_kind::route) out.push_back(schemas_.decode<PlannedRoute>(record));
    return true;
  };
  if (!damage_) {
    reader_->read(take, 0, log_kind::route);
    return out;
  }
  const auto take_if_whole = [&](const RunLogReader::Record& record) {
    try {
      return take(record);
    } catch (const InputError&) {
      return true;
    }
  };
  reader_->read_intact(take_if_whole, [](const RunLogReader::Lost&) {});
  return out;
}

}  // namespace arcbid
