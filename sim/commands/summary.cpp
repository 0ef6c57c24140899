// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace arcbid {

using nlohmann::json;

double SimSummary::Figure::mean() const {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double SimSummary::Figure::at(double share) const {
  if (values.empty()) return 0;
  std::vector<double> sorted = values;
  const auto place = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(place),
                   sorted.end());
  return sorted[place];
}

json SimSummary::to_json(const Figure& figure) {
  return {{"mean", figure.mean()},
          {"median", figure.at(0.5)},
          {"p99", figure.at(0.99)},
          {"max", figure.at(1)}};
}

void SimSummary::add(const PricedResult& result) {
  const WorldResult& w = result.world;
  const auto seconds = [](TimeNs ns) { return static_cast<double>(ns) * 1e-9; };
  ++worlds_;
  violations_ += w.violations.empty() ? 0 : 1;
  disagreed_ += w.agreed ? 0 : 1;
  refused_ += w.refused;
  steps_ += w.steps;
  of_steps_.values.push_back(static_cast<double>(w.steps) / static_cast<double>(w.most_steps));
  if (!w.agreed) return;
  rounds_.values.push_back(w.rounds);
  messages_.values.push_back(static_cast<double>(w.messages));
  kilobytes_.values.push_back(static_cast<double>(w.bytes) * 1e-3);
  agreement_s_.values.push_back(seconds(w.agreed_ns));
  const double after_s = std::max(0.0, seconds(w.agreed_ns - w.calm_ns));
  after_calm_s_.values.push_back(after_s);
  of_bound_.values.push_back(w.bound_ns > 0 ? after_s / seconds(w.bound_ns) : 0);
  makespan_s_.values.push_back(w.makespan_s);
  if (!result.fault_free || !result.fault_free->agreed) return;
  const WorldResult& free = *result.fault_free;
  price_rounds_.values.push_back(w.rounds / std::max(1.0, static_cast<double>(free.rounds)));
  price_messages_.values.push_back(static_cast<double>(w.messages) /
                                   std::max(1.0, static_cast<double>(free.messages)));
  if (free.makespan_s > 0) price_makespan_.values.push_back(w.makespan_s / free.makespan_s);
}

json SimSummary::to_json(double wall_s) const {
  return {{"worlds", worlds_},
          {"violations", violations_},
          {"disagreed", disagreed_},
          {"refused", refused_},
          {"steps", steps_},
          {"wall_s", wall_s},
          {"worlds_per_minute", 60 * static_cast<double>(worlds_) / std::max(wall_s, 1e-9)},
          {"rounds", to_json(rounds_)},
          {"messages", to_json(messages_)},
          {"kilobytes", to_json(kilobytes_)},
          {"agreement_s", to_json(agreement_s_)},
          {"agreement_after_calm_s", to_json(after_calm_s_)},
          {"share_of_bound", to_json(of_bound_)},
          {"share_of_most_steps", to_json(of_steps_)},
          {"makespan_s", to_json(makespan_s_)},
          {"price_of_faults",
           {{"rounds", to_json(price_rounds_)},
            {"messages", to_json(price_messages_)},
            {"makespan", to_json(price_makespan_)}}}};
}

std::string SimSummary::table(double wall_s) const {
  std::string out =
      fmt::format("{:<24}{:>10} {:>10} {:>10} {:>10}\n", "", "mean", "median", "99 %", "most");
  const auto row = [&out](const char* name, const Figure& f) {
    if (f.values.empty()) return;
    out += fmt::format("{:<24}{:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g}\n", name, f.mean(), f.at(0.5),
                       f.at(0.99), f.at(1));
  };
  row("rounds", rounds_);
  row("messages", messages_);
  row("kB", kilobytes_);
  row("agreement, s", agreement_s_);
  row("after the calm, s", after_calm_s_);
  row("share of the bound", of_bound_);
  row("share of most steps", of_steps_);
  row("makespan, s", makespan_s_);
  row("price: rounds, times", price_rounds_);
  row("price: messages, times", price_messages_);
  row("price: makespan, times", price_makespan_);
  out += fmt::format(
      "\n{} worlds, {} with violations, {} steps, {} messages refused, {:.0f} worlds a minute\n",
      worlds_, violations_, steps_, refused_,
      60 * static_cast<double>(worlds_) / std::max(wall_s, 1e-9));
  return out;
}

}  // namespace arcbid
