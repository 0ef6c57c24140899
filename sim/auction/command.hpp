// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "core/base/error.hpp"

namespace arcbid {

/// `arcbid auction`: one instance of points, or of arcs, in synchronous rounds, all agents in one
/// thread.
class AuctionCommand {
 public:
  explicit AuctionCommand(CLI::App& app);
  ~AuctionCommand();
  bool parsed() const;
  Exit run() const;

 private:
  struct Arguments;
  void add_arc_options(CLI::App& command, CLI::Option& points);
  Exit run_arcs() const;

  std::unique_ptr<Arguments> arguments_;
  const CLI::App* command_;
};

}  // namespace arcbid
