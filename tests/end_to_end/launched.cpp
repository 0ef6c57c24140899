// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/launched.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

namespace arcbid::testing {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<std::string> arcbid_command(const std::vector<std::string>& arguments) {
  // Standard error joins standard output; exec keeps the PID.
  std::vector<std::string> command{"/bin/sh", "-c", "exec \"$0\" \"$@\" 2>&1",
                                   std::string(ARCBID_BIN_DIR) + "/arcbid"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  // Runs here are about processes, and the processors are theirs.
  if (!arguments.empty() && arguments.front() == "run") command.push_back("--no-certificate");
  return command;
}

}  // namespace

Scratch::Scratch() {
  std::string name = (std::filesystem::temp_directory_path() / "arcbid-test-XXXXXX").string();
  path_ = mkdtemp(name.data());
}

Scratch::~Scratch() {
  std::filesystem::remove_all(path_);
}

std::filesystem::path Scratch::file(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

Launched::Launched(const std::vector<std::string>& arguments)
    : child_("arcbid", arcbid_command(arguments)) {}

bool Launched::wait_for(const std::string& text, double limit_s) {
  const auto start = Clock::now();
  for (;;) {
    for (const std::string& line : child_.read_lines()) output_ += line + "\n";
    if (const auto at = output_.find(text, seen_); at != std::string::npos) {
      seen_ = at + text.size();
      return true;
    }
    if (child_.output() < 0 || since(start) > limit_s) return false;
    pollfd pipe{child_.output(), POLLIN, 0};
    ::poll(&pipe, 1, 50);
  }
}

std::optional<int> Launched::wait_for_end(double limit_s) {
  const auto start = Clock::now();
  while (child_.running() && since(start) < limit_s) {
    for (const std::string& line : child_.read_lines()) output_ += line + "\n";
    child_.poll();
    std::this_thread::sleep_for(10ms);
  }
  for (const std::string& line : child_.read_lines()) output_ += line + "\n";
  if (child_.running()) return std::nullopt;
  if (child_.ended_by_signal()) return -*child_.ended_by_signal();
  return child_.exit_code();
}

std::map<std::string, pid_t> processes_of(const std::filesystem::path& out) {
  const auto file = out / "processes.json";
  for (int tries = 0; tries < 500 && !std::filesystem::exists(file); ++tries)
    std::this_thread::sleep_for(10ms);
  std::map<std::string, pid_t> processes;
  for (const auto& process : read_json(file)) processes[process["name"]] = process["pid"];
  return processes;
}

bool alive(pid_t pid) {
  return kill(pid, 0) == 0;
}

bool all_gone(const std::map<std::string, pid_t>& processes, double limit_s) {
  const auto start = Clock::now();
  const auto any = [&] {
    return std::any_of(processes.begin(), processes.end(),
                       [](const auto& process) { return alive(process.second); });
  };
  while (any() && since(start) < limit_s) std::this_thread::sleep_for(20ms);
  return !any();
}

nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in, nullptr, false);
}

std::set<std::string> shared_memory() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm"))
    names.insert(entry.path().filename().string());
  return names;
}

void expect_checked(const nlohmann::json& result, std::size_t agents) {
  ASSERT_TRUE(result.is_object());
  EXPECT_EQ(result["agents"], agents);
  EXPECT_TRUE(result["agreement"]["reached"]);
  for (const char* check : {"conflict_free", "complete", "arcs_conserved", "routes_valid"})
    EXPECT_TRUE(result["checks"][check]) << check << ": " << result["problems"].dump();
}

std::string demo_config() {
  return std::string(ARCBID_SOURCE_DIR) + "/configs/demo.yaml";
}

std::string shared_data(const std::string& relative) {
  return std::string(ARCBID_SHARED_DATA) + "/" + relative;
}

}  // namespace arcbid::testing
