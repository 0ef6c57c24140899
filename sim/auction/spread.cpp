// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/spread.hpp"

#include <cmath>
#include <numeric>

namespace arcbid {
namespace {

double mean(std::span<const double> loads) {
  return std::accumulate(loads.begin(), loads.end(), 0.0) / static_cast<double>(loads.size());
}

double squared_deviations(std::span<const double> loads) {
  const double mu = mean(loads);
  double sum = 0;
  for (const double load : loads) sum += (load - mu) * (load - mu);
  return sum;
}

}  // namespace

double uniformity(std::span<const double> loads) {
  if (loads.empty()) return 0;
  const auto n = static_cast<double>(loads.size());
  return n / (squared_deviations(loads) + n);
}

double variation(std::span<const double> loads) {
  if (loads.empty() || !(mean(loads) > 0)) return 0;
  return std::sqrt(squared_deviations(loads) / static_cast<double>(loads.size())) / mean(loads);
}

double cv_time(const CheckReport& report) {
  std::vector<double> times_s;
  for (const AgentFigures& figures : report.per_agent) times_s.push_back(figures.time_s);
  return variation(times_s);
}

}  // namespace arcbid
