// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/doctor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>

#include "core/base/error.hpp"
#include "sim/replay/examination.hpp"

namespace arcbid {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

constexpr std::array run_files{"arcs.json", "config.yaml", "processes.json", "result.json"};

std::vector<Path> logs_in(const Path& run) {
  std::error_code failed, none;
  std::vector<Path> files;
  for (const auto& entry : std::filesystem::directory_iterator(run / "logs", failed)) {
    Path file = entry.path();
    if (file.extension() == ".sqlite-wal" && entry.file_size(none) > 0)
      file.replace_extension(".sqlite");  // perhaps all there is
    if (file.extension() == ".sqlite") files.push_back(file);
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  const bool is_run = std::any_of(run_files.begin(), run_files.end(), [&run](const char* name) {
    return std::filesystem::exists(run / name);
  });
  if (files.empty() && !is_run)
    throw InputError(
        fmt::format("{}: is no run directory: it has no logs, and none of the files "
                    "that a run leaves",
                    run.string()));
  return files;
}

/// What the file's name says, for what is inside may be damaged.
LogReport named(const Path& file) {
  static const std::regex pattern(
      // A recorded world counts its lives behind the incarnation.
      "(?:(coordinator)|agent_([0-9]{1,10}))\\.([0-9]{1,19})(?:\\.[0-9]+)?\\.sqlite");
  LogReport log;
  log.file = file;
  std::smatch found;
  const std::string name = file.filename().string();
  if (!std::regex_match(name, found, pattern)) return log;
  log.role = found[1].matched ? "coordinator" : "agent";
  if (found[2].matched) log.agent = static_cast<std::uint32_t>(std::stoul(found[2]));
  log.life = std::stoull(found[3]);
  return log;
}

void sort(std::vector<LogReport>& logs) {
  std::stable_sort(logs.begin(), logs.end(), [](const LogReport& a, const LogReport& b) {
    return std::tuple(a.role == "agent", a.agent, a.life) <
           std::tuple(b.role == "agent", b.agent, b.life);
  });
}

/// Processes of which no log is left, by what the launcher wrote down.
void miss_processes(const Path& run, std::vector<LogReport>& logs) {
  std::ifstream in(run / "processes.json");
  const json processes = in ? json::parse(in, nullptr, false) : json();
  if (!processes.is_array()) return;
  std::map<std::uint32_t, std::vector<std::uint64_t>> pids;  // by agent; 0: the coordinator
  static const std::regex number("[0-9]{1,9}");
  for (const json& process : processes) {
    if (!process.is_object() || !process.value("pid", json()).is_number_unsigned()) continue;
    const json name = process.value("name", json());
    if (!name.is_string()) continue;
    const std::string text = name == "coordinator" ? "0" : name.get<std::string>();
    for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
      pids[static_cast<std::uint32_t>(std::stoul(at->str()))].push_back(process["pid"]);
  }
  for (auto& [agent, left] : pids) {
    std::size_t unexplained = left.size();
    for (const LogReport& log : logs)
      if (!log.role.empty() && log.agent == agent && unexplained > 0) --unexplained;
    for (const LogReport& log : logs)
      if (log.agent == agent) std::erase(left, log.pid);
    for (std::size_t n = 0; n < std::min(unexplained, left.size()); ++n) {
      LogReport missing;
      missing.role = agent == 0 ? "coordinator" : "agent";
      missing.agent = agent;
      missing.pid = left[n];
      missing.never_began = agent != 0;
      missing.not_read =
          missing.never_began
              ? "there is no log of it, and nobody heard it: it ended before it began"
              : "there is no log of it";
      logs.push_back(std::move(missing));
    }
  }
}

/// A process that is killed in its first moments leaves a log behind that it was just making.
void pardon_the_unborn(std::vector<LogReport>& logs) {
  for (LogReport& log : logs) {
    if (log.not_read.empty() || log.heard_only || log.file.empty()) continue;
    std::error_code none;
    const bool was_being_made = std::filesystem::exists(log.file.string() + "-journal", none) ||
                                log.not_read.ends_with("it is empty") ||
                                log.not_read.find("no such table") != std::string::npos;
    if (!was_being_made) continue;
    log.never_began = true;
    log.not_read += ", and nobody heard it: it ended while it was making its log";
  }
}

}  // namespace

bool LogReport::whole() const {
  if (never_began) return true;
  if (!not_read.empty() || !lost.empty() || !complaints.empty() || wal.lost_commits > 0 ||
      unread_schema)
    return false;
  if (!heard_only) return true;
  if (ended_by || !heard_only->behind_its_end) return false;
  const TimeNs span_ns = heard_only->last_ns - std::max(heard_only->first_ns, last_ns);
  return span_ns <= uncommitted_ns;
}

bool RunReport::whole() const {
  return std::all_of(logs.begin(), logs.end(), [](const LogReport& log) { return log.whole(); });
}

RunReport examine(const Path& run) {
  RunReport report;
  for (const Path& file : logs_in(run)) report.logs.push_back(named(file));
  sort(report.logs);
  Evidence evidence;
  for (std::size_t l = 0; l < report.logs.size(); ++l) examine_log(report.logs[l], l, evidence);
  evidence.judge(report.logs);
  miss_processes(run, report.logs);
  pardon_the_unborn(report.logs);
  sort(report.logs);
  return report;
}

}  // namespace arcbid
