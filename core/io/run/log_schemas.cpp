// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/log_schemas.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/io/build/build.hpp"
#include "core/io/run/agent_log.hpp"

namespace arcbid {
namespace {

std::string build_in(const RunLogReader& log) {
  const nlohmann::json build = log.meta("build");
  if (!build.is_object()) return "";
  const auto text = [&build](const char* key, const char* otherwise) {
    const nlohmann::json value = build.value(key, nlohmann::json());
    return value.is_string() ? value.get<std::string>() : std::string(otherwise);
  };
  return fmt::format("{} {}", text("version", "?"), text("commit", ""));
}

/// One line, however much is otherwise.
std::string shortened(std::vector<std::string> differences) {
  constexpr std::size_t most = 8;
  const std::size_t all = differences.size();
  differences.resize(std::min(all, most));
  std::string out = fmt::format("{}", fmt::join(differences, ", "));
  return all > most ? fmt::format("{}, and {} more", out, all - most) : out;
}

}  // namespace

LogSchemas::LogSchemas(const RunLogReader& log) : file_(log.file()), build_(build_in(log)) {
  for (const RecordKind& kind : log.kinds()) {
    const auto read_as = [&]<class Record>(std::string_view name, std::type_identity<Record>) {
      if (kind.name == name) compare(kind, schema_of<Record>(), name_of_record<Record>());
    };
    read_as(log_kind::mission, std::type_identity<Mission>());
    read_as(log_kind::birth, std::type_identity<Birth>());
    read_as(log_kind::step, std::type_identity<Step>());
    read_as(log_kind::route, std::type_identity<PlannedRoute>());
    read_as(log_kind::heard_status, std::type_identity<StatusMessage>());
  }
}

/// A schema that is lost is taken for this build's.
void LogSchemas::compare(const RecordKind& kind, const std::string& own, std::string_view name) {
  if (kind.schema.empty() || kind.schema == own) return;
  const auto say = [&](std::optional<std::string>& what, const std::string& why) {
    const std::string line = fmt::format("{}: {}", kind.name, why);
    what = what ? fmt::format("{}; {}", *what, line)
                : fmt::format("written by arcbid {}, this is {} {}; {}",
                              build_.empty() ? "?" : build_, build_version(), build_commit(), line);
  };
  try {
    StoredSchema stored(kind.schema);
    say(other_, shortened(stored.differences(StoredSchema(own), name)));
    others_.emplace_back(kind.name, std::move(stored));
  } catch (const InputError& error) {
    unread_kinds_.push_back(kind.name);
    say(unread_, fmt::format("its schema cannot be read: {}", error.what()));
  }
}

const StoredSchema* LogSchemas::of(std::string_view kind) const {
  for (const auto& [name, schema] : others_)
    if (name == kind) return &schema;
  return nullptr;
}

bool LogSchemas::is_unread(std::string_view kind) const {
  return std::find(unread_kinds_.begin(), unread_kinds_.end(), kind) != unread_kinds_.end();
}

void LogSchemas::demand_read() const {
  if (unread_) throw InputError(fmt::format("{}: {}", file_.string(), *unread_));
}

void LogSchemas::demand_own() const {
  if (other_)
    throw InputError(fmt::format("{}: plays, but cannot be verified: {}", file_.string(), *other_));
}

void LogSchemas::refuse(const RunLogReader::Record& record, const char* why) const {
  throw InputError(
      fmt::format("{}: record {} ({}): {}", file_.string(), record.seq, record.kind, why));
}

std::vector<std::string> lines_about(const OtherLogs& logs, std::string_view what) {
  std::vector<std::string> out;
  for (const auto& [why, files] : logs)
    out.push_back(fmt::format(
        "{}{}: {}: {}", files.front(),
        files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : std::string(), what,
        why));
  return out;
}

}  // namespace arcbid
