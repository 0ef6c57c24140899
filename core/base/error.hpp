// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <source_location>
#include <stdexcept>
#include <string>

namespace arcbid {

/// Bad input at the edge: a file, a config, the command line. The message is one line that names
/// the file, the field or line, the value, and what would be legal. Caught once, in main: exit
/// code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The world failed us while we worked (a full disk, a file that vanished): nobody's input is to
/// blame. Caught once, in main: exit code 1.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Programs' exit codes.
enum class Exit : int { done = 0, check_failed = 1, bad_input = 2 };

/// Our own bug: on in release builds too, prints where and aborts. Never triggered by user input.
inline void check(bool holds, const char* what,
                  std::source_location at = std::source_location::current()) {
  if (holds) return;
  fmt::print(stderr, "{}:{}: internal check failed: {}\n", at.file_name(), at.line(), what);
  std::abort();
}

}  // namespace arcbid
