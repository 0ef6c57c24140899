// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid export RUN --mcap FILE --csv DIR`.
class ExportCommand {
 public:
  explicit ExportCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  CLI::App* command_;
  std::string run_, mcap_, csv_;
  bool force_ = false;
};

}  // namespace arcbid
