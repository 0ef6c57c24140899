// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid doctor RUN`.
class DoctorCommand {
 public:
  explicit DoctorCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  CLI::App* command_;
  std::string run_, salvage_;
  bool json_ = false;
};

}  // namespace arcbid
