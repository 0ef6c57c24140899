// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid replay RUN`: plays it in the terminal, verifies it, or says it all again over DDS.
class ReplayCommand {
 public:
  explicit ReplayCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  /// `programs`: the folder where arcbid-replayer is.
  Exit run(const std::filesystem::path& programs) const;

 private:
  /// What chooses a part of the run, and how that is shown.
  std::vector<CLI::Option*> add_playing();
  Exit verify_all() const;
  Exit play() const;
  Exit publish(const std::filesystem::path& programs) const;

  CLI::App* command_;
  std::string run_, from_, until_, topic_;
  bool verify_ = false, loop_ = false, dds_ = false;
  std::optional<double> rate_;
  std::optional<std::uint32_t> agent_, arc_, domain_;
  int step_ = 0;
};

}  // namespace arcbid
