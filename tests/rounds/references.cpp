// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rounds/references.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

namespace arcbid::testing {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(ARCBID_SHARED_DATA) / "cbba";
const std::map<std::string, ScoreKind> families{{"MOD", ScoreKind::independent},
                                                {"TDA", ScoreKind::discounted_append},
                                                {"TDI", ScoreKind::discounted_insert},
                                                {"TDW", ScoreKind::discounted_insert_warped},
                                                {"RPT", ScoreKind::minimax}};
const std::map<std::string, Graph> graphs{
    {"complete", Graph::complete}, {"ring", Graph::ring}, {"line", Graph::line}};

}  // namespace

bool references_exist() {
  return fs::exists(folder);
}

std::string references_folder() {
  return folder.string();
}

std::vector<Reference> references(const std::string& results, const std::string& family) {
  std::vector<Reference> out;
  for (const auto& entry : fs::directory_iterator(folder / results)) {
    std::ifstream file(entry.path());
    Reference r{entry.path().filename().string(), nlohmann::json::parse(file), {}, {}, {}};
    if (r.result["family"] != family) continue;
    const std::string name = r.result["instance"];
    const std::string values = r.result["values"];
    r.instance = read_instance(folder / "instances" / (name + "_agents.csv"),
                               folder / "instances" / (name + "_tasks.csv"), "value_" + values);
    r.settings.score = families.at(family);
    r.settings.bundle_limit = r.result["Lt"];
    r.graph = graphs.at(r.result["graph"]);
    out.push_back(std::move(r));
  }
  std::sort(out.begin(), out.end(),
            [](const Reference& a, const Reference& b) { return a.label < b.label; });
  return out;
}

nlohmann::json to_json(const std::vector<std::vector<TaskId>>& paths) {
  nlohmann::json out = nlohmann::json::array();
  for (const auto& path : paths) {
    out.push_back(nlohmann::json::array());
    for (const TaskId task : path) out.back().push_back(task.value);
  }
  return out;
}

}  // namespace arcbid::testing
