// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/io/process/process.hpp"

namespace arcbid {

/// Parses, then runs `body`. --help and --version print and are exit code 0; a wrong command line
/// is one line on standard error and exit code 2.
template <class Body>
int run_command_line(CLI::App& app, int argc, char** argv, Body body) {
  return run_program([&]() -> Exit {
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& wish) {
      app.exit(wish);
      return Exit::done;
    } catch (const CLI::ParseError& error) {
      throw InputError(fmt::format("{}: {} (see --help)", app.get_name(), error.what()));
    }
    return body();
  });
}

}  // namespace arcbid
