// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/structure/bridge_arcs.hpp"
#include "sim/certificate/certificate.hpp"
#include "sim/reproduce/experiment.hpp"
#include "sim/reproduce/paper.hpp"

namespace arcbid::reproduce {

/// What the bridge is modelled by: the paper's two, and two that show where they stand.
enum class ModelKind : std::uint8_t {
  slices,           ///< Fig. 5 (a): no horizontal surface
  slices_and_rows,  ///< Fig. 5 (b): the paper's arcs
  completed,        ///< what missions are planned with
  units             ///< Fig. 6: a viewpoint a cell
};
inline constexpr std::array<std::string_view, 4> model_names{
    "slices alone", "slices and rows", "arcs as completed", "unit decomposition"};

struct Model {
  ModelKind kind;
  std::vector<Arc> arcs;  ///< a viewpoint is one of a millimetre: legs begin and end on arcs
  double planned_cpu_s = 0;
};

/// D = spacing_m; a square of D by D, straight ahead at the stand-off, is just within range.
CoverageSettings coverage_settings(const Settings& settings, double spacing_m);

Model make_model(ModelKind kind, const Structure& structure, const CoverageSettings& coverage);

/// A model as one UAV flies it, in the order that CRSOM and local search find, around what is in
/// the way, and what the
/// certificate says of that, on samples that no model was planned with.
struct FlownModel {
  certificate::Flown flown;
  certificate::Certificate certificate;
};
FlownModel fly(Model& model, const Settings& settings, const Structure& structure,
               const CoverageSettings& coverage);

/// Columns and rows that Table 1 and Figs. 5 and 6 have in common.
std::vector<Column> model_columns();
struct Repeated {
  double planned_cpu_s = 0;  ///< mean
  std::size_t least_nodes = 0, most_nodes = 0;
};
std::vector<Cell> model_row(const Model& model, const Repeated& repeated,
                            const certificate::Certificate& certificate,
                            const paper::Modelling& paper);

/// log10 of (Q - 1)! / 2, the orders of a closed tour through Q nodes.
double log10_orders(std::size_t q);

/// The bridge, to be named in a report.
std::string bridge_text(const ParametricBridge& bridge);

/// Seen from above one corner.
PlotPoint projected(const Vec3& at_m);
std::vector<PlotPoint> projected(const std::vector<Waypoint>& line);

}  // namespace arcbid::reproduce
