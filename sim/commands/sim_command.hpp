// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "core/base/error.hpp"
#include "sim/world/spec.hpp"

namespace arcbid {

/// `arcbid sim`: many worlds, drawn from a config by their seeds, checked at every step; and
/// `arcbid shrink`, which makes one that fails smaller.
class SimCommand {
 public:
  explicit SimCommand(CLI::App& app);
  ~SimCommand();
  bool parsed() const;
  Exit run() const;

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  Exit run_shrink() const;
  Exit run_one(const WorldSpec& spec) const;
  void write_faults(const WorldSpec& spec) const;

  const CLI::App* command_;
  const CLI::App* shrink_;
};

}  // namespace arcbid
