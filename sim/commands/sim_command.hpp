// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid sim`: many worlds, drawn from a config by their seeds, checked at every step.
class SimCommand {
 public:
  explicit SimCommand(CLI::App& app);
  ~SimCommand();
  bool parsed() const;
  Exit run() const;

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  const CLI::App* command_;
};

}  // namespace arcbid
