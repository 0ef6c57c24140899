// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/result.hpp"

#include <fmt/format.h>

#include "sim/auction/spread.hpp"

namespace arcbid {

using nlohmann::json;

namespace {

/// Totals of the link matrix, and its worst link.
std::string links_line(const json& links, const std::string& tier) {
  std::uint64_t sent = 0, dropped = 0, delayed = 0, duplicated = 0;
  double worst = -1;
  std::string worst_link;
  for (const json& link : links) {
    const std::uint64_t of = link["sent"], lost = link["dropped"];
    sent += of;
    dropped += lost;
    delayed += link["delayed"].get<std::uint64_t>();
    duplicated += link["duplicated"].get<std::uint64_t>();
    const double share = of == 0 ? 0 : static_cast<double>(lost) / static_cast<double>(of);
    if (share <= worst) continue;
    worst = share;
    worst_link = fmt::format("{} -> {}", link["from"].get<int>(), link["to"].get<int>());
  }
  const double share = sent == 0 ? 0 : static_cast<double>(dropped) / static_cast<double>(sent);
  return fmt::format(
      "{} {} sent, {} dropped by faults ({:.1f} %), {} delayed, {} duplicated; worst {}: {:.1f} %",
      sent, tier, dropped, 100 * share, delayed, duplicated, worst_link, 100 * worst);
}

std::string stretches(std::size_t count) {
  return count == 1 ? "1 stretch" : fmt::format("{} stretches", count);
}

}  // namespace

json result_json(const CheckReport& report, const Monitor& monitor,
                 const std::vector<ProcessEnd>& processes, double run_s) {
  const auto outcome = monitor.outcome();
  const Traffic traffic = monitor.traffic();
  json out{{"schema", 1},
           {"agents", report.agents},
           {"fleet", monitor.agents().size()},
           {"arcs", report.arcs},
           {"tasks", report.tasks},
           {"agreement",
            {{"reached", outcome.has_value()},
             {"time_s", outcome ? outcome->agreed_s : 0.0},
             {"auction_s", outcome ? outcome->auction_s : 0.0},
             {"rounds", outcome ? outcome->rounds : 0u}}},
           {"checks",
            {{"conflict_free", report.conflict_free},
             {"complete", report.complete},
             {"arcs_conserved", report.arcs_conserved},
             {"routes_valid", report.routes_valid}}},
           {"makespan_s", report.makespan_s},
           {"total_length_m", report.total_length_m},
           {"uniformity", {{"count", report.uniformity_count}, {"time", report.uniformity_time}}},
           {"cv_time", cv_time(report)},
           {"messages",
            {{"sent", traffic.sent},
             {"received", traffic.received},
             {"dropped", traffic.dropped},
             {"bytes", traffic.bytes}}},
           {"run_s", run_s},
           {"problems", report.problems},
           {"no_bidders", json(no_bidders_json(report))},
           {"left_m", report.left_m()},
           {"warnings", monitor.warnings()}};
  out["per_agent"] = json::array();
  for (const AgentFigures& figures : report.per_agent)
    out["per_agent"].push_back({{"agent", figures.agent},
                                {"arcs", figures.arcs},
                                {"tasks", figures.tasks},
                                {"length_m", figures.length_m},
                                {"time_s", figures.time_s}});
  for (const auto& [link, t] : monitor.links())
    out["links"].push_back({{"from", link.first},
                            {"to", link.second},
                            {"sent", t.sent},
                            {"dropped", t.dropped},
                            {"delayed", t.delayed},
                            {"duplicated", t.duplicated}});
  out["processes"] = json::array();
  for (const ProcessEnd& process : processes)
    out["processes"].push_back(
        {{"name", process.name},
         {"pid", process.pid},
         {"exit_code", process.exit_code ? json(*process.exit_code) : json(nullptr)},
         {"signal", process.signal ? json(*process.signal) : json(nullptr)}});
  return out;
}

std::string result_table(const json& r) {
  std::string text = fmt::format("\n{:>8} {:>7} {:>7} {:>11} {:>11}\n", "agent", "arcs", "tasks",
                                 "metres", "seconds");
  for (const json& a : r["per_agent"])
    text += fmt::format("{:>8} {:>7} {:>7} {:>11.1f} {:>11.1f}\n", a["agent"].get<int>(),
                        a["arcs"].get<int>(), a["tasks"].get<int>(), a["length_m"].get<double>(),
                        a["time_s"].get<double>());
  const json &agreement = r["agreement"], &messages = r["messages"], &checks = r["checks"];
  const auto row = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("{:<20}{}\n", name, value);
  };
  text += '\n';
  row("makespan", fmt::format("{:.1f} s", r["makespan_s"].get<double>()));
  if (!r["no_bidders"].empty())
    row("left undone", fmt::format("{} without a bidder, {:.1f} m",
                                   stretches(r["no_bidders"].size()), r["left_m"].get<double>()));
  row("total length", fmt::format("{:.1f} m", r["total_length_m"].get<double>()));
  row("uniformity E",
      fmt::format("{:.4f} on {} tasks, {:.4g} on flight times, which vary by {:.1f} % (CV)",
                  r["uniformity"]["count"].get<double>(), r["tasks"].get<std::size_t>(),
                  r["uniformity"]["time"].get<double>(), 100 * r["cv_time"].get<double>()));
  row("agreement",
      agreement["reached"].get<bool>()
          ? fmt::format("proven {:.2f} s after launch, {} rounds",
                        agreement["time_s"].get<double>(), agreement["rounds"].get<int>())
          : "not reached");
  row("messages",
      fmt::format("{} sent ({} kB), {} received, {} dropped", messages["sent"].get<std::uint64_t>(),
                  messages["bytes"].get<std::uint64_t>() / 1000,
                  messages["received"].get<std::uint64_t>(),
                  messages["dropped"].get<std::uint64_t>()));
  if (r.contains("links")) row("links", links_line(r["links"], r["fault_tier"]));
  std::string verdict;
  for (const auto& [name, holds] : checks.items())
    verdict +=
        fmt::format("{}{} {}", verdict.empty() ? "" : ", ", name, holds.get<bool>() ? "yes" : "NO");
  row("checked", verdict);
  return text;
}

}  // namespace arcbid
