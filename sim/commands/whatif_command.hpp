// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "sim/replay/what_if.hpp"

namespace arcbid {

/// `arcbid whatif RUN`: the same inputs under other rules, as simulated worlds.
class WhatIfCommand {
 public:
  explicit WhatIfCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  OtherRules rules() const;

  CLI::App* command_;
  std::string run_, policy_, score_, seeds_;
  std::optional<std::uint32_t> agents_, bundle_limit_;
  std::vector<std::uint32_t> without_;
  std::optional<double> loss_;
  unsigned jobs_;
};

}  // namespace arcbid
