// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid explain RUN`: why who has what, and what would have been otherwise.
class ExplainCommand {
 public:
  explicit ExplainCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  CLI::App* command_;
  std::string run_, json_;
  std::optional<std::uint32_t> arc_, task_, agent_;
};

}  // namespace arcbid
