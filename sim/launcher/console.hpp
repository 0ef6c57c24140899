// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/faults/tier.hpp"
#include "sim/launcher/monitor.hpp"

namespace arcbid {

/// Progress for people: a line for everything that matters, and on a terminal a last line that is
/// written over while rounds go by.
class Console {
 public:
  /// `tier`: what the losses that it shows are losses of.
  explicit Console(FaultTier tier);
  void line(double time_s, const std::string& text);
  void progress(double time_s, const Monitor& monitor);

 private:
  void wipe();
  const bool terminal_;
  const FaultTier tier_;
  bool dirty_ = false;  // a passing line is on screen
  std::size_t warnings_ = 0;
  bool published_ = false, up_ = false, started_ = false, agreed_ = false, routed_ = false;
  bool refusal_told_ = false;
};

}  // namespace arcbid
