// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "sim/checker/checker.hpp"

namespace arcbid {

nlohmann::ordered_json no_bidders_json(const CheckReport& report) {
  auto out = nlohmann::ordered_json::array();
  for (const LeftUndone& left : report.left)
    out.push_back({{"arc", left.arc},
                   {"from_m", left.from_m},
                   {"to_m", left.to_m},
                   {"why", left.why},
                   {"text", left.text}});
  return out;
}

std::string to_json(const CheckReport& report) {
  using Json = nlohmann::ordered_json;
  Json agents = Json::array();
  for (const AgentFigures& a : report.per_agent)
    agents.push_back({{"agent", a.agent},
                      {"arcs", a.arcs},
                      {"tasks", a.tasks},
                      {"length_m", a.length_m},
                      {"time_s", a.time_s}});
  const Json json{{"schema", 1},
                  {"ok", report.ok()},
                  {"all_done", report.all_done()},
                  {"conflict_free", report.conflict_free},
                  {"complete", report.complete},
                  {"arcs_conserved", report.arcs_conserved},
                  {"routes_valid", report.routes_valid},
                  {"problems", report.problems},
                  {"no_bidders", no_bidders_json(report)},
                  {"arcs", report.arcs},
                  {"tasks", report.tasks},
                  {"agents", report.agents},
                  {"makespan_s", report.makespan_s},
                  {"total_length_m", report.total_length_m},
                  {"uniformity_count", report.uniformity_count},
                  {"uniformity_time", report.uniformity_time},
                  {"per_agent", agents}};
  // Text out of a damaged file may hold bytes that are not UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace arcbid
