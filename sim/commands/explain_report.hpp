// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/replay/counterfactual.hpp"
#include "sim/replay/what_if.hpp"

namespace arcbid {

/// Stories of tasks and agents, for people and as JSON.
class ExplainReport {
 public:
  explicit ExplainReport(const RunArchive& run);

  void add(TaskId task);
  void add(AgentId agent);

  const std::string& text() const { return text_; }
  const nlohmann::json& json() const { return json_; }

 private:
  /// The run as a world, and again with one agent alive.
  struct Alive {
    std::optional<WorldResult> before, after;
    std::string problem;  ///< why there is no such world
  };
  const Alive& alive(const Explanation& death);
  nlohmann::json tell_without(const Explanation& drop);
  nlohmann::json tell(const WithoutMessage& other);
  nlohmann::json tell(const Explanation& death, const Alive& worlds);
  template <class... T>
  void line(fmt::format_string<T...> format, T&&... values);

  const RunArchive& run_;
  Playback playback_;
  Explainer explainer_;
  std::map<AgentId, Alive> alive_;
  std::string text_;
  nlohmann::json json_;
};

}  // namespace arcbid
