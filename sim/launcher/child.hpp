// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace arcbid {

/// A process of ours: started with its standard output on a pipe, ended only by its PID. It ends by
/// itself
/// (--parent) when this process does. Its standard error is ours.
class Child {
 public:
  /// `command`: program path and arguments. Throws InputError when it cannot be started.
  Child(std::string name, const std::vector<std::string>& command);
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  /// Kills and reaps it if it still runs.
  ~Child();

  const std::string& name() const { return name_; }
  pid_t pid() const { return pid_; }
  int output() const { return output_; }  ///< descriptor to poll; -1: closed
  bool running() const { return !status_; }

  /// Whole lines that have arrived; does not block. Closes the pipe at its end.
  std::vector<std::string> read_lines();
  void signal(int number) const;
  /// Reaps it if it has ended.
  void poll();

  /// Once ended: its exit code, or the signal that ended it.
  std::optional<int> exit_code() const;
  std::optional<int> ended_by_signal() const;

 private:
  std::string name_;
  pid_t pid_ = -1;
  int output_ = -1;
  std::string partial_;
  std::optional<int> status_;
};

}  // namespace arcbid
