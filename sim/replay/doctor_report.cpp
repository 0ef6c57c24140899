// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/base/seconds.hpp"
#include "sim/replay/doctor.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

std::string range(std::int64_t from, std::optional<std::int64_t> to) {
  if (!to) return fmt::format("from {} on", from);
  return *to == from ? fmt::format("{}", from) : fmt::format("{} to {}", from, *to);
}

std::string who(const LogReport& log) {
  if (log.role.empty()) return log.file.filename().string();
  std::string out = log.role == "agent" ? fmt::format("agent {:>3}  life ", log.agent)
                                        : std::string("coordinator     ");
  return out + (log.life > 0 ? fmt::format("{}", log.life) : fmt::format("of process {}", log.pid));
}

std::string how_it_ended(const LogReport& log) {
  if (!log.ended_by && !log.lost.empty() && !log.lost.back().to_seq) return "how it ended is lost";
  return log.ended_by ? fmt::format("ended by {}", *log.ended_by)
                      : "killed: its log ends without a word";
}

std::string verdict(const LogReport& log) {
  if (log.never_began) return "nothing: " + log.not_read;
  if (!log.not_read.empty()) return "lost: " + log.not_read;
  std::string out = log.whole() ? (log.ended_by ? "whole" : "whole to its last commit") : "damaged";
  if (log.records == 0) return out + ": no records; " + how_it_ended(log);
  return fmt::format("{}: {} records, {}, {:.3f} s to {:.3f} s; {}", out, log.records,
                     range(log.first_seq, log.last_seq), seconds(log.first_ns),
                     seconds(log.last_ns), how_it_ended(log));
}

/// What lies between and behind the losses.
std::string intact(const LogReport& log) {
  std::string out;
  const auto add = [&out](std::int64_t from, std::int64_t to) {
    if (from <= to) out += (out.empty() ? "" : ", ") + range(from, to);
  };
  std::int64_t next = log.first_seq;
  for (const auto& lost : log.lost) {
    add(next, lost.from_seq - 1);
    if (!lost.to_seq) return out;
    next = std::max(next, *lost.to_seq + 1);
  }
  add(next, log.last_seq);
  return out;
}

std::string heard_only(const LogReport& log) {
  const HeardOnly& heard = *log.heard_only;
  std::string numbers;
  for (const auto& [from, to] : heard.numbers)
    numbers += (numbers.empty() ? "" : ", ") +
               range(static_cast<std::int64_t>(from), static_cast<std::int64_t>(to));
  std::string out =
      fmt::format("others heard {} message{} of it, number{} {}, not on its record", heard.messages,
                  heard.messages == 1 ? "" : "s", heard.messages == 1 ? "" : "s", numbers);
  if (log.not_read.empty() && heard.behind_its_end)
    out += fmt::format(": by their receipt it lived at least {:.1f} ms beyond its last record{}",
                       static_cast<double>(heard.last_ns - log.last_ns) / 1e6,
                       log.whole() ? ", which is what a killed process had not yet committed" : "");
  return out;
}

std::vector<std::string> particulars(const LogReport& log) {
  std::vector<std::string> out;
  if (log.other_schema) out.push_back("plays, but cannot be verified: " + *log.other_schema);
  if (log.unread_schema) out.push_back("does not play: " + *log.unread_schema);
  for (const auto& lost : log.lost)
    out.push_back(fmt::format("lost: records {}: {}", range(lost.from_seq, lost.to_seq), lost.why));
  if (!log.lost.empty() && log.records > 0) out.push_back("intact: records " + intact(log));
  for (const std::string& complaint : log.complaints)
    out.push_back("SQLite's quick check: " + complaint);
  if (log.wal.lost_commits > 0)
    out.push_back(
        fmt::format("lost: {} commits behind damage in its write-ahead log", log.wal.lost_commits));
  if (log.wal.unfinished_bytes > 0)
    out.push_back(
        fmt::format("its write-ahead log ends with {} bytes of a commit that was never "
                    "finished, or was cut off",
                    log.wal.unfinished_bytes));
  if (log.heard_only) out.push_back(heard_only(log));
  return out;
}

}  // namespace

std::string describe(const RunReport& report) {
  std::string out;
  std::size_t whole = 0, killed = 0, not_read = 0, records = 0;
  for (const LogReport& log : report.logs) {
    out += fmt::format("{}  {}\n", who(log), verdict(log));
    for (const std::string& line : particulars(log)) out += fmt::format("    {}\n", line);
    whole += log.whole() ? 1 : 0;
    killed += log.whole() && !log.ended_by ? 1 : 0;
    not_read += log.whole() || log.not_read.empty() ? 0 : 1;
    records += log.records;
  }
  return out + fmt::format(
                   "{} logs: {} whole ({} of killed processes), {} damaged, {} lost; {} "
                   "records intact\n",
                   report.logs.size(), whole, killed, report.logs.size() - whole - not_read,
                   not_read, records);
}

json to_json(const RunReport& report) {
  json logs = json::array();
  for (const LogReport& log : report.logs) {
    json lost = json::array();
    for (const auto& [from, to, why] : log.lost)
      lost.push_back({{"from", from}, {"to", to ? json(*to) : json()}, {"why", why}});
    json heard;
    if (log.heard_only)
      heard = {{"messages", log.heard_only->messages},
               {"numbers", log.heard_only->numbers},
               {"behind_its_end", log.heard_only->behind_its_end},
               {"first_ns", log.heard_only->first_ns},
               {"last_ns", log.heard_only->last_ns}};
    logs.push_back({{"file", log.file.filename().string()},
                    {"role", log.role},
                    {"agent", log.agent},
                    {"life", log.life},
                    {"pid", log.pid},
                    {"whole", log.whole()},
                    {"not_read", log.not_read.empty() ? json() : json(log.not_read)},
                    {"records", log.records},
                    {"first", {{"seq", log.first_seq}, {"t_ns", log.first_ns}}},
                    {"last", {{"seq", log.last_seq}, {"t_ns", log.last_ns}}},
                    {"lost", lost},
                    {"quick_check", log.complaints},
                    {"other_schema", log.other_schema ? json(*log.other_schema) : json()},
                    {"unread_schema", log.unread_schema ? json(*log.unread_schema) : json()},
                    {"wal",
                     {{"commits", log.wal.commits},
                      {"lost_commits", log.wal.lost_commits},
                      {"unfinished_bytes", log.wal.unfinished_bytes}}},
                    {"ended_by", log.ended_by ? json(*log.ended_by) : json()},
                    {"heard_only", heard}});
  }
  return {{"whole", report.whole()}, {"logs", logs}};
}

}  // namespace arcbid
