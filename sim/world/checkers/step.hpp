// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/auction/agent.hpp"

// The checkers know the auction's values (messages, statements, updates) and none of its code: they
// recompute what they need.
namespace arcbid {

/// What one step of one life did. A life is one process: an agent that comes back has a new one.
struct SeenStep {
  TimeNs now_ns = 0;
  AgentId agent;
  std::uint32_t life = 0;  ///< unique in the world
  const Update& update;
  const View& view;  ///< V as the agent holds it after the step
  /// z_i and y_i as the agent believes them; given where it decided.
  const std::vector<Belief>* winners = nullptr;
};

/// Something that must never happen, and did.
struct Violation {
  TimeNs now_ns = 0;
  std::string checker;
  std::string what;
  friend bool operator==(const Violation&, const Violation&) = default;
};

/// Collects what a checker finds.
class Findings {
 public:
  template <class... T>
  void add(TimeNs now_ns, const char* checker, fmt::format_string<T...> format, T&&... values) {
    if (found_.size() < most)
      found_.push_back({now_ns, checker, fmt::format(format, std::forward<T>(values)...)});
  }
  const std::vector<Violation>& found() const { return found_; }

 private:
  static constexpr std::size_t most = 20;  // the first ones tell
  std::vector<Violation> found_;
};

}  // namespace arcbid
