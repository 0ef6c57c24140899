// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/base/error.hpp"
#include "core/io/config.hpp"

namespace arcbid {

/// `arcbid plan STRUCTURE`: arcs, auction and routes in this one process, and their certificate.
class PlanCommand {
 public:
  explicit PlanCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  Config config() const;

  CLI::App* command_;
  std::string structure_, unit_, up_, config_, sensor_, out_;
  std::optional<std::uint32_t> agents_;
};

}  // namespace arcbid
