// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid replay RUN --verify`.
class ReplayCommand {
 public:
  explicit ReplayCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  Exit verify_all() const;

  CLI::App* command_;
  std::string run_;
  bool verify_ = false;
};

}  // namespace arcbid
