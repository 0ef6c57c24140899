// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "sim/reproduce/models.hpp"

namespace arcbid::reproduce {
namespace {

constexpr const paper::Modelling& kWidest = paper::kModelling.back();  // D = 5 m, as in the paper
constexpr int kColours = 8;

/// Every arc a line, its ends dots: where a UAV comes in and goes out.
Panel arcs_panel(const Model& model) {
  Panel panel{fmt::format("{}: {} arcs", model_names[static_cast<std::size_t>(model.kind)],
                          model.arcs.size()),
              "",
              "",
              {}};
  for (int colour = 0; colour < kColours; ++colour) {
    Series lines{"", {}, true, false, colour}, ends{"", {}, false, true, colour};
    for (const Arc& arc : model.arcs) {
      if (static_cast<int>(arc.id.value % kColours) != colour) continue;
      lines.strokes.push_back(projected(arc.waypoints));
      ends.strokes.push_back({lines.strokes.back().front(), lines.strokes.back().back()});
    }
    panel.series.push_back(std::move(lines));
    panel.series.push_back(std::move(ends));
  }
  return panel;
}

std::vector<Panel> units_panels(const Model& model, const certificate::Flown& flown) {
  Series dots{"", {{}}, false, true, 0}, tour{"", {}, true, false, 1};
  for (const Arc& arc : model.arcs)
    dots.strokes[0].push_back(projected(arc.waypoints.front().position_m));
  for (const certificate::FlownLeg& leg : flown.flights.front().legs)
    tour.strokes.push_back(projected(leg.waypoints));
  return {{fmt::format("(a) {} viewpoints", model.arcs.size()), "", "", {dots}},
          {"(b) the way through them", "", "", {tour, dots}}};
}

Model flown_model(ModelKind kind, const Settings& settings, Finding& out,
                  certificate::Flown* flown) {
  settings.tell(fmt::format("{}: {}", out.name, model_names[static_cast<std::size_t>(kind)]));
  const Structure structure = generate(settings.bridge);
  const CoverageSettings coverage = coverage_settings(settings, kWidest.spacing_m);
  Model model = make_model(kind, structure, coverage);
  FlownModel result = fly(model, settings, structure, coverage);
  const std::size_t nodes = model.arcs.size();
  out.table.rows.push_back(
      model_row(model, {model.planned_cpu_s, nodes, nodes}, result.certificate, kWidest));
  if (flown) *flown = std::move(result.flown);
  return model;
}

Finding empty(const char* name, const char* title, const Settings& settings) {
  return {
      .name = name,
      .title = title,
      .setting = fmt::format("{} D = {:.0f} m.", bridge_text(settings.bridge), kWidest.spacing_m),
      .table = {model_columns(), {}},
      .pictures = {},
      .differences = {}};
}

}  // namespace

Finding fig5(const Settings& settings) {
  Finding out = empty("fig5", "Fig. 5: arcs without and with supplementary planes", settings);
  Picture picture{"fig5", "Arcs by slices alone (a), with rows (b), and as completed", 1, {}};
  for (const ModelKind kind : {ModelKind::slices, ModelKind::slices_and_rows, ModelKind::completed})
    picture.panels.push_back(arcs_panel(flown_model(kind, settings, out, nullptr)));
  out.pictures = {std::move(picture)};
  out.differences = {
      "As in the paper, slices alone leave the deck out, and rows fill most of that; by the "
      "certificate they do not fill all of it. Rows of the paper lie on the surface, ours at the "
      "stand-off, above it and below."};
  return out;
}

Finding fig6(const Settings& settings) {
  Finding out = empty("fig6", "Fig. 6: unit decomposition", settings);
  certificate::Flown flown;
  const Model model = flown_model(ModelKind::units, settings, out, &flown);
  out.pictures = {
      {"fig6", "Viewpoints (a), and the way through them (b)", 1, units_panels(model, flown)}};
  out.differences = {
      "The way is flown around what is in it; the paper does not say whether its is."};
  return out;
}

}  // namespace arcbid::reproduce
