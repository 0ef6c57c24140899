// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "sim/launcher/child.hpp"

namespace arcbid::testing {

/// A directory that is gone when the test is.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a file there and returns its path.
  std::filesystem::path file(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// `arcbid` as a user starts it, with its output at hand. Ends with the object.
class Launched {
 public:
  explicit Launched(const std::vector<std::string>& arguments);

  /// Reads output until a line contains `text`; false when it ended or `limit_s` passed before.
  bool wait_for(const std::string& text, double limit_s);
  /// Its exit code, or minus the signal that ended it; nullopt after `limit_s`.
  std::optional<int> wait_for_end(double limit_s);

  const std::string& output() const { return output_; }
  pid_t pid() const { return child_.pid(); }

 private:
  Child child_;
  std::string output_;
  std::size_t seen_ = 0;  // of output_, by wait_for()
};

/// The processes of the run in `out` by name ("coordinator", "agent 1"); waits for the file.
std::map<std::string, pid_t> processes_of(const std::filesystem::path& out);
bool alive(pid_t pid);
/// Waits up to `limit_s` for all of them to be gone.
bool all_gone(const std::map<std::string, pid_t>& processes, double limit_s);

nlohmann::json read_json(const std::filesystem::path& file);
/// The names of everything in /dev/shm.
std::set<std::string> shared_memory();

/// What every good run's result.json says; failures are the calling test's.
void expect_checked(const nlohmann::json& result, std::size_t agents);

std::string demo_config();
std::string shared_data(const std::string& relative);

}  // namespace arcbid::testing
