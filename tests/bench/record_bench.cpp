// SPDX-License-Identifier: GPL-3.0-or-later
// What recording costs: the CPU of a live run, and the CPU of writing its logs once more, both
// measured here. The limit is 5 %.
//
//   record_bench [CONFIG [FAULTS]]    (configs/quick8.yaml)
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/io/run/agent_log.hpp"
#include "sim/replay/run_archive.hpp"

namespace {

using namespace arcbid;

double cpu_s(int whose) {
  rusage usage{};
  getrusage(whose, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Written {
  std::size_t records = 0;
  std::uintmax_t bytes = 0;
  double cpu_s = 0;
};

/// Reads the life's records first, so that only writing is counted. Commits come as they did.
void write_again(const LifeLog& life, const std::filesystem::path& file, Written& all) {
  std::vector<std::pair<TimeNs, Step>> steps;
  life.steps([&](std::size_t mark, Step step, std::string_view) {
    steps.emplace_back(life.marks()[mark].t_ns, std::move(step));
    return true;
  });
  const auto routes = life.routes();
  const double before_s = cpu_s(RUSAGE_SELF);
  {
    AgentLog log(file, {life.agent(), life.incarnation(), 0}, {});
    log.birth(life.born_ns(), *life.birth(), *life.mission());
    for (const auto& [t_ns, step] : steps) {
      log.step(t_ns, step);
      log.commit_if_due(t_ns);
    }
    for (const PlannedRoute& route : routes) log.route(life.last_ns(), route);
  }
  all.cpu_s += cpu_s(RUSAGE_SELF) - before_s;
  all.records += steps.size() + routes.size() + 2;
  all.bytes += std::filesystem::file_size(file);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string source = ARCBID_SOURCE_DIR;
  const std::string config = argc > 1 ? argv[1] : source + "/configs/quick8.yaml";
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("record_bench.{}", getpid());
  std::filesystem::create_directories(folder);
  const std::string command =
      fmt::format("{}/arcbid run {} {} --out {} > {}/run.txt", ARCBID_BIN_DIR, config,
                  argc > 2 ? fmt::format("--faults {}", argv[2]) : "", (folder / "run").string(),
                  folder.string());
  const int code = std::system(command.c_str());
  const double run_s = cpu_s(RUSAGE_CHILDREN);
  Written again;
  if (code == 0)
    for (const RunArchive run = open_run(folder / "run"); const LifeLog& life : run.lives)
      write_again(life, folder / fmt::format("{}.sqlite", again.records), again);
  std::filesystem::remove_all(folder);
  if (code != 0) return 1;
  fmt::print("{}: {:.2f} s of CPU in all its processes\n", config, run_s);
  fmt::print("its {} records, {:.2f} MB, written again: {:.3f} s of CPU, {:.1f} us each\n",
             again.records, 1e-6 * static_cast<double>(again.bytes), again.cpu_s,
             1e6 * again.cpu_s / static_cast<double>(again.records));
  fmt::print("recording costs {:.1f} % of the run (limit 5 %)\n", 100 * again.cpu_s / run_s);
  return again.cpu_s <= 0.05 * run_s ? 0 : 1;
}
