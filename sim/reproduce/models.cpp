// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/models.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/airspace/surroundings.hpp"
#include "core/coverage/coverage_arcs.hpp"
#include "core/coverage/unit_decomposition.hpp"
#include "core/io/process/process.hpp"
#include "sim/reproduce/one_route.hpp"

namespace arcbid::reproduce {
namespace {

/// Numbered anew, as missions want them.
std::vector<Arc> without_rows(std::vector<Arc> arcs) {
  std::erase_if(arcs, [](const Arc& arc) { return arc.kind != ArcKind::outline; });
  for (std::uint32_t a = 0; a < arcs.size(); ++a) arcs[a].id = {a};
  return arcs;
}

std::vector<Arc> viewpoints(const Structure& structure, const CoverageSettings& coverage) {
  std::vector<Arc> arcs;
  for (const Waypoint& w : unit_decomposition(structure, coverage).viewpoints)
    arcs.push_back({{static_cast<std::uint32_t>(arcs.size())},
                    ArcKind::gap,
                    {w, {w.position_m + 0.001 * Vec3::UnitZ(), w.look}}});
  return arcs;
}

std::vector<Arc> arcs_of(ModelKind kind, const Structure& structure,
                         const CoverageSettings& coverage) {
  if (kind == ModelKind::units) return viewpoints(structure, coverage);
  if (kind == ModelKind::completed) return coverage_arcs(structure, coverage).arcs;
  std::vector<Arc> arcs = bridge_arcs(structure, coverage).arcs;
  return kind == ModelKind::slices ? without_rows(std::move(arcs)) : arcs;
}

}  // namespace

CoverageSettings coverage_settings(const Settings& settings, double spacing_m) {
  CoverageSettings coverage;
  coverage.spacing_m = spacing_m;
  coverage.sensor.range_m = std::hypot(coverage.standoff_m, spacing_m / std::sqrt(2.0));
  coverage.seed = settings.seed;
  coverage.threads = settings.jobs;
  return coverage;
}

Model make_model(ModelKind kind, const Structure& structure, const CoverageSettings& coverage) {
  const double start_s = process_cpu_s();
  Model model{kind, arcs_of(kind, structure, coverage), 0};
  model.planned_cpu_s = process_cpu_s() - start_s;
  return model;
}

FlownModel fly(Model& model, const Settings& settings, const Structure& structure,
               const CoverageSettings& coverage) {
  std::vector<std::string> warnings;
  const Airspace airspace = Surroundings(structure, coverage).airspace(model.arcs, warnings);
  const auto& name = model_names[static_cast<std::size_t>(model.kind)];
  for (const std::string& warning : warnings) settings.tell(fmt::format("{}: {}", name, warning));
  const Vec3 home_m(-settings.bridge.length_m / 2, -settings.bridge.width_m / 2 - 10, 0);
  FlownModel out{one_route(model.arcs, airspace, home_m), {}};
  certificate::Settings how;
  how.sensor = coverage.sensor;
  how.safety_m = coverage.safety_m;
  how.ground_clearance_m = coverage.ground_clearance_m;
  how.spacing_m = 0.6;  // 0.3 m would take four times as long for a figure of the same kind
  how.mission_seed = coverage.seed;
  how.threads = settings.jobs;
  out.certificate = certificate::certify(structure, out.flown, how);
  return out;
}

std::vector<Column> model_columns() {
  return {{"d_m", "D (m)", 0},
          {"model", "model", 0},
          {"planned_cpu_s", "planned in (CPU s)", 1},
          {"paper_s", "paper (s)", 1},
          {"nodes", "nodes Q", 0},
          {"paper_nodes", "paper", 0},
          {"nodes_least", "least Q", 0},
          {"nodes_most", "most Q", 0},
          {"log10_orders", "log10 (Q-1)!/2", 0},
          {"paper_log10_orders", "paper", 0},
          {"covered_of_visible_percent", "of visible covered (%)", 2},
          {"paper_covered_percent", "paper (%)", 0},
          {"flown_m", "flown by one (m)", 0},
          {"flown_m_per_m2", "m/m2", 3},
          {"least_clearance_m", "least clearance (m)", 2}};
}

std::vector<Cell> model_row(const Model& model, const Repeated& repeated,
                            const certificate::Certificate& certificate,
                            const paper::Modelling& paper) {
  const bool in_paper = model.kind == ModelKind::slices_and_rows || model.kind == ModelKind::units;
  const bool units = model.kind == ModelKind::units;
  const auto printed = [in_paper](double value) { return in_paper ? Cell(value) : Cell(); };
  const auto nodes = units ? paper.viewpoints : paper.arcs;
  const auto count = [](std::size_t n) { return Cell(static_cast<double>(n)); };
  return {paper.spacing_m,
          std::string(model_names[static_cast<std::size_t>(model.kind)]),
          repeated.planned_cpu_s,
          printed(units ? paper.units_s : paper.arcs_s),
          count(model.arcs.size()),
          printed(nodes),
          count(repeated.least_nodes),
          count(repeated.most_nodes),
          log10_orders(model.arcs.size()),
          printed(log10_orders(nodes)),
          100 * certificate.coverage_of_visible(),
          printed(paper::kCoveragePercent),
          certificate.flown_m,
          certificate.metres_per_m2(),
          certificate.min_clearance_m()};
}

double log10_orders(std::size_t q) {
  return q < 3 ? 0 : (std::lgamma(static_cast<double>(q)) - std::log(2.0)) / std::log(10.0);
}

std::string bridge_text(const ParametricBridge& bridge) {
  return fmt::format("Girder bridge, {:.0f} m by {:.0f} m, deck at {:.0f} m, {} piers, {} girders.",
                     bridge.length_m, bridge.width_m, bridge.deck_height_m, bridge.piers,
                     bridge.girders);
}

PlotPoint projected(const Vec3& at_m) {
  // Axonometric, flat enough that a long bridge still fills a panel.
  return {at_m.x() + 0.5 * at_m.y(), 1.2 * at_m.y() - 0.15 * at_m.x() + at_m.z()};
}

std::vector<PlotPoint> projected(const std::vector<Waypoint>& line) {
  std::vector<PlotPoint> points;
  for (const Waypoint& w : line) points.push_back(projected(w.position_m));
  return points;
}

}  // namespace arcbid::reproduce
