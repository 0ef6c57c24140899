// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/checker/checker.hpp"
#include "sim/launcher/monitor.hpp"

namespace arcbid {

/// How one of our processes ended.
struct ProcessEnd {
  std::string name;
  int pid = 0;
  std::optional<int> exit_code;
  std::optional<int> signal;
};

/// RUN/result.json (docs/RUN_DIRECTORY.md): the checker's verdict and figures with the run's own.
nlohmann::json result_json(const CheckReport& report, const Monitor& monitor,
                           const std::vector<ProcessEnd>& processes, double run_s);

/// The table that ends a run.
std::string result_table(const nlohmann::json& result);

}  // namespace arcbid
