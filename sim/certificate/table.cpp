// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "sim/certificate/files.hpp"

namespace arcbid::certificate {
namespace {

std::string metres(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f} m", value) : "nothing flown";
}

std::string place_of_least(const Certificate& c) {
  for (const AgentClearance& agent : c.clearance)
    if (agent.flight.distance_m == c.min_clearance_m() && std::isfinite(c.min_clearance_m()))
      return fmt::format(", agent {}, leg {}, at ({:.2f}, {:.2f}, {:.2f})", agent.agent,
                         agent.flight.leg, agent.flight.at_m.x(), agent.flight.at_m.y(),
                         agent.flight.at_m.z());
  return "";
}

}  // namespace

std::string table(const Certificate& c) {
  std::string text;
  const auto row = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("{:<20}{}\n", name, value);
  };
  row("coverage", fmt::format("{:.3f} % of what is visible, {:.2f} % of the whole surface",
                              100 * c.coverage_of_visible(), 100 * c.coverage_of_total()));
  row("samples",
      fmt::format("{} sides of {:.2f} m points, {} visible, {} covered, seen {:.1f} times",
                  c.surface_samples, c.spacing_m, c.visible_samples, c.covered_samples,
                  c.redundancy.mean));
  std::string reasons;
  for (std::size_t f = 1; f < fate_names.size(); ++f)
    if (c.fates[f] > 0)
      reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", c.fates[f], fate_names[f]);
  if (!reasons.empty()) row("not covered", reasons);
  if (c.ground_samples > 0)
    row("ground", fmt::format("{} samples, not to be inspected", c.ground_samples));
  row("clearance",
      fmt::format("{} ({:.3f} m asked for){}{}", metres(c.min_clearance_m()), c.settings.safety_m,
                  c.min_clearance_m() >= c.settings.safety_m - tolerance_m ? "" : ": TOO NEAR",
                  place_of_least(c)));
  if (c.home_clearance_m() < c.settings.safety_m - tolerance_m)
    row("over a home", fmt::format("{}: TOO NEAR", metres(c.home_clearance_m())));
  if (c.below_floor_m() > 0)
    row("below the floor", fmt::format("{:.1f} m flown", c.below_floor_m()));
  row("effort", fmt::format("{:.4f} m flown for a square metre covered", c.metres_per_m2()));
  return text;
}

}  // namespace arcbid::certificate
