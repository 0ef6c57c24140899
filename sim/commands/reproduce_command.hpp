// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid reproduce [WHAT...]`: the paper's experiments, with its numbers beside ours.
class ReproduceCommand {
 public:
  explicit ReproduceCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  std::string again() const;

  CLI::App* command_;
  std::vector<std::string> what_;
  std::string out_, tsplib_;
  std::uint32_t repeats_ = 20;
  std::uint64_t seed_ = 1;
  unsigned jobs_ = 1;
};

}  // namespace arcbid
