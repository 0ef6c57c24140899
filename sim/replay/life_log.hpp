// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/io/record/records.hpp"
#include "core/io/run/log_schemas.hpp"
#include "core/io/run/run_log_reader.hpp"

namespace arcbid {

/// A message's name: no two messages of a mission share it.
struct MessageId {
  AgentId sender;
  std::uint64_t incarnation = 0;
  std::uint64_t sequence = 0;
  friend auto operator<=>(const MessageId&, const MessageId&) = default;
};

/// What a step was about, without its contents: enough to find one's way in a long log.
struct Mark {
  std::int64_t seq = 0;    ///< the record
  TimeNs t_ns = 0;         ///< when it was taken, since launch
  std::uint8_t event = 0;  ///< index of Event::what
  bool refused = false, decided = false, changed = false, started = false, lost = false,
       agreed = false, died = false, returned = false, learnt = false;
  std::uint32_t round = 0;                 ///< decisions made until then
  std::optional<MessageId> heard;          ///< the message that was the event
  std::uint64_t first_sent = 0, sent = 0;  ///< numbers and count of the messages that went out
};

/// A statement that this life came to hold.
struct Learnt {
  std::size_t mark = 0;  ///< at which step
  StatementKey key;
  bool is_own = false;  ///< found in the step's update; else in its event, or a tombstone
};

/// One life of one agent, as its log has it. Opening reads everything once; contents are read again
/// when they are asked for. A log whose end is missing or whose pages are damaged gives what is
/// intact, before the damage and behind it.
class LifeLog {
 public:
  /// Throws InputError: one line with the file's name.
  explicit LifeLog(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return reader_->file(); }
  AgentId agent() const { return agent_; }
  std::uint64_t incarnation() const { return incarnation_; }
  std::uint64_t pid() const { return pid_; }
  std::uint64_t seed() const { return seed_; }
  const std::string& build() const { return schemas_.build(); }  ///< "0.1.0 a8a2cbd"
  const LogSchemas& schemas() const { return schemas_; }
  /// Null: this life never had the mission, and there are no steps.
  const std::shared_ptr<const Mission>& mission() const { return mission_; }
  const std::optional<Birth>& birth() const { return birth_; }
  TimeNs born_ns() const { return born_ns_; }  ///< when it had the mission
  TimeNs last_ns() const { return last_ns_; }
  const std::string& ended_by() const { return ended_by_; }  ///< empty: it did not come to say so
  const std::optional<std::string>& damage() const { return damage_; }  ///< the first
  /// How many marks lie before the first damage. Those behind it are on record, but what led to
  /// them is not: good for a view, not for a proof.
  std::optional<std::size_t> gap() const { return gap_; }

  const std::vector<Mark>& marks() const { return marks_; }
  /// By roster position: what it came to hold of each member, in order.
  const std::vector<std::vector<Learnt>>& learnt() const { return learnt_; }
  /// The whole step of a mark.
  Step step(std::size_t mark) const;
  /// All steps from a mark on, until `take` returns false. `bytes`: as they are on record.
  void steps(const std::function<bool(std::size_t mark, Step step, std::string_view bytes)>& take,
             std::size_t from = 0) const;
  /// Routes planned, by the agreement's hash.
  std::vector<PlannedRoute> routes() const;
  const RunLogReader& reader() const { return *reader_; }

 private:
  void read_head();
  void index();
  void lost(const RunLogReader::Lost& lost);
  void take(const RunLogReader::Record& record, Step& room);
  void mark(const RunLogReader::Record& record, const Step& step);
  void expect_mission(std::uint64_t named);
  void learn(const Statement& statement, bool is_own);
  void bury(AgentId agent);
  std::size_t position(AgentId agent) const;

  std::unique_ptr<RunLogReader> reader_;
  LogSchemas schemas_;
  AgentId agent_;
  std::uint64_t incarnation_ = 0, pid_ = 0, seed_ = 0;
  std::string ended_by_;
  std::shared_ptr<const Mission> mission_;
  std::optional<Birth> birth_;
  std::uint64_t mission_digest_ = 0;
  bool names_mission_ = false, names_another_ = false;  // in messages sent
  TimeNs born_ns_ = 0, last_ns_ = 0;
  std::optional<std::string> damage_;
  std::optional<std::size_t> gap_;
  std::vector<Mark> marks_;
  std::vector<std::vector<Learnt>> learnt_;
  std::uint32_t round_ = 0;
  std::size_t tasks_ = 0;  // of the mission
};

}  // namespace arcbid
