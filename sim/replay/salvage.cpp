// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/salvage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/error.hpp"
#include "core/io/record/stored_schema.hpp"
#include "core/io/run/agent_log.hpp"

namespace arcbid {
namespace {

namespace fs = std::filesystem;

/// What logs of one run have in common, for those that have lost theirs.
struct Common {
  std::map<std::string, RecordKind> kinds;  ///< with their schemas
  std::string mission;                      ///< as it is on record
};

bool is_lost(const LogReport& log, std::int64_t seq) {
  for (const auto& lost : log.lost)
    if (seq >= lost.from_seq && (!lost.to_seq || seq <= *lost.to_seq)) return true;
  return false;
}

/// Whether records can be read by it: what is damaged may be none any more.
bool is_sound(const std::string& schema) {
  try {
    const StoredSchema stored(schema);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

Common common_of(const RunReport& report) {
  Common common;
  for (const LogReport& log : report.logs) {
    if (!log.not_read.empty()) continue;
    const RunLogReader reader(log.file);
    for (const RecordKind& kind : reader.kinds())
      if (is_sound(kind.schema)) common.kinds[kind.name] = kind;
    if (!common.mission.empty() || log.role != "agent" || !log.lost.empty() || log.unread_schema)
      continue;
    if (const auto mission = reader.first(log_kind::mission)) common.mission = mission->body;
  }
  return common;
}

/// Copies one log.
class Copy {
 public:
  Copy(const LogReport& log, const Common& common, const fs::path& to)
      : log_(log), common_(common), from_(log.file), to_(to / "logs" / log.file.filename()) {
    for (const auto& [key, value] : from_.meta()) to_.meta(key, value);
    if (from_.meta("schema").is_null()) to_.meta("schema", RunLog::schema);
    if (from_.meta("process").is_null() && log.role == "agent")  // the file's name says as much
      to_.meta("process", {{"role", log.role}, {"agent", log.agent}, {"incarnation", log.life}});
    to_.meta("last_seq", log.last_seq);
    for (RecordKind kind : from_.kinds()) {
      const auto known = common.kinds.find(kind.name);
      if (known != common.kinds.end() && !is_sound(kind.schema)) kind = known->second;
      to_.kind(kind);
    }
  }

  void write() {
    from_.read_intact(
        [this](const RunLogReader::Record& record) {
          if (!is_lost(log_, record.seq)) take(record);
          return true;
        },
        [](const RunLogReader::Lost&) {});
    to_.commit();
  }

 private:
  void take(const RunLogReader::Record& record) {
    has_mission_ = has_mission_ || record.kind == log_kind::mission;
    // An agent's mission stands right before its birth.
    if (record.kind == log_kind::birth && !has_mission_ && record.seq > 1 &&
        !common_.mission.empty())
      put(record.seq - 1, record.t_ns, log_kind::mission, common_.mission);
    put(record.seq, record.t_ns, record.kind, std::string(record.body));
  }
  void put(std::int64_t seq, TimeNs t_ns, std::string_view kind, std::string body) {
    to_.append_as(seq, t_ns, to_.kind({std::string(kind), "", ""}), std::move(body));
  }

  const LogReport& log_;
  const Common& common_;
  const RunLogReader from_;
  RunLog to_;
  bool has_mission_ = false;
};

void copy_other_files(const fs::path& run, const fs::path& to) {
  for (const auto& entry : fs::directory_iterator(run))
    if (entry.path().filename() != "logs")
      fs::copy(entry.path(), to / entry.path().filename(), fs::copy_options::recursive);
}

}  // namespace

void salvage(const fs::path& run, const RunReport& report, const fs::path& to) {
  std::error_code none;
  if (fs::exists(to, none) && !(fs::is_directory(to, none) && fs::is_empty(to, none)))
    throw InputError(fmt::format("{}: is not empty; name a new directory", to.string()));
  const fs::path inside = fs::weakly_canonical(to, none), of = fs::weakly_canonical(run, none);
  if (std::mismatch(of.begin(), of.end(), inside.begin(), inside.end()).first == of.end())
    throw InputError(fmt::format("{}: is inside the run; name a directory beside it", to.string()));
  try {
    fs::create_directories(to / "logs");
    copy_other_files(run, to);
  } catch (const fs::filesystem_error& error) {
    throw RunError(fmt::format("{}: cannot be written: {}", to.string(), error.code().message()));
  }
  const Common common = common_of(report);
  for (const LogReport& log : report.logs)
    if (log.not_read.empty()) Copy(log, common, to).write();
}

}  // namespace arcbid
