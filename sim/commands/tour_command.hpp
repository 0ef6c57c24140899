// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid tour FILE.tsp --pairs FILE.pairs`: the closed tour through a TSPLIB instance's cities,
/// joined two by two.
class TourCommand {
 public:
  explicit TourCommand(CLI::App& app);
  bool parsed() const { return command_->parsed(); }
  Exit run() const;

 private:
  CLI::App* command_;
  std::string tsp_, pairs_, solver_ = "crsom+ls", json_;
  double deadline_ms_ = 100;
  std::optional<std::uint32_t> iterations_;
  std::uint64_t seed_ = 1;
  std::uint32_t epochs_;
};

}  // namespace arcbid
