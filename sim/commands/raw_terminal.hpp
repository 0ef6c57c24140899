// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace arcbid {

/// Keys one by one and without an echo, on standard input, as long as it lives. However the process
/// ends, and while it is stopped, the terminal is as it was found. One at a time.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

  /// What was typed, waiting that long for the first of it.
  std::string read(std::chrono::milliseconds timeout) const;
};

}  // namespace arcbid
