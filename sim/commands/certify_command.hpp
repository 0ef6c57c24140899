// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid certify RUN`.
class CertifyCommand {
 public:
  explicit CertifyCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  CLI::App* command_;
  std::string run_, structure_;
  double spacing_m_ = 0.3;
};

}  // namespace arcbid
