// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/auction/rounds.hpp"

namespace arcbid::testing {

/// One result of an independent implementation, and what it was computed from.
struct Reference {
  std::string label;  ///< its file's name
  nlohmann::json result;
  Instance instance;
  AuctionSettings settings;  ///< the policy is for the test to say
  Graph graph = Graph::complete;
};

/// Whether the third-party data is here.
bool references_exist();
std::string references_folder();

/// Every result of one family (MOD, TDA, TDI, TDW, RPT) in `results` (ref_published, ref_rebuild).
std::vector<Reference> references(const std::string& results, const std::string& family);

/// Paths as those files have them.
nlohmann::json to_json(const std::vector<std::vector<TaskId>>& paths);

}  // namespace arcbid::testing
