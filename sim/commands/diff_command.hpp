// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid diff RUN1 RUN2`: where two runs part, and what that cost.
class DiffCommand {
 public:
  explicit DiffCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  /// Exit::done: the same allocation; check_failed: another.
  Exit run() const;

 private:
  CLI::App* command_;
  std::string first_, second_;
};

}  // namespace arcbid
