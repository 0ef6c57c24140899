// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/run_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <thread>

#include "core/base/error.hpp"
#include "core/io/run/log_files.hpp"
#include "core/io/run/run_lock.hpp"

namespace arcbid {
namespace {

using Path = std::filesystem::path;

struct Opened {
  std::optional<LifeLog> life;
  std::string problem;
};

Opened opened(const Path& file) {
  try {
    LifeLog life(file);
    if (life.birth() && life.mission()) return {std::move(life), ""};
    return {std::nullopt, life.damage() ? *life.damage()
                                        : fmt::format("{}: this life never had the mission",
                                                      file.filename().string())};
  } catch (const InputError& error) {
    return {std::nullopt, error.what()};
  }
}

void take(RunArchive& run, Opened opened) {
  if (!opened.life) return run.unreadable.push_back(opened.problem);
  const auto& mission = opened.life->mission();
  if (run.mission && digest(*mission) != digest(*run.mission))
    throw InputError(fmt::format("{}: mission {:016x}, but the other logs have {:016x}",
                                 opened.life->file().string(), digest(*mission),
                                 digest(*run.mission)));
  run.mission = mission;
  run.lives.push_back(std::move(*opened.life));
}

nlohmann::json result_of(const Path& run) {
  std::ifstream in(run / "result.json", std::ios::binary);
  return in ? nlohmann::json::parse(in, nullptr, false) : nlohmann::json();
}

}  // namespace

RunArchive open_run(const Path& directory) {
  RunArchive run;
  run.directory = directory;
  const std::vector<Path> files = agents_logs(directory);
  const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t from = 0; from < files.size(); from += at_once) {
    std::vector<std::future<Opened>> some;
    for (std::size_t f = from; f < std::min(files.size(), from + at_once); ++f)
      some.push_back(std::async(std::launch::async, opened, files[f]));
    for (auto& one : some) take(run, one.get());
  }
  if (run.lives.empty())
    throw InputError(fmt::format("{}: no agent's log has the mission{}{}",
                                 (directory / "logs").string(),
                                 run.unreadable.empty() ? "" : "; the first one: ",
                                 run.unreadable.empty() ? "" : run.unreadable.front()));
  std::sort(run.lives.begin(), run.lives.end(), [](const LifeLog& a, const LifeLog& b) {
    return std::pair(a.agent(), a.born_ns()) < std::pair(b.agent(), b.born_ns());
  });
  run.tasks =
      split(run.mission->arcs, run.mission->auction.split_m, run.mission->auction.max_tasks);
  run.is_live = goes_on(directory);
  run.result = result_of(directory);
  return run;
}

std::vector<std::string> unverifiable(const RunArchive& run) {
  OtherLogs logs;
  for (const LifeLog& life : run.lives)
    if (const auto& other = life.schemas().other())
      logs[*other].push_back(life.file().filename().string());
  return lines_about(logs, "plays, but cannot be verified");
}

}  // namespace arcbid
