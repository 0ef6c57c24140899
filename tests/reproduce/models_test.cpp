// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/models.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reproduce/small.hpp"

namespace arcbid::reproduce {
namespace {

TEST(Models, OrdersOfAClosedTour) {
  EXPECT_NEAR(log10_orders(3), 0, 1e-12);                    // 2! / 2
  EXPECT_NEAR(log10_orders(4), std::log10(3), 1e-12);        // 3! / 2
  EXPECT_NEAR(log10_orders(11), std::log10(1814400), 1e-9);  // 10! / 2
  EXPECT_EQ(log10_orders(0), 0);
}

TEST(Models, ASquareAheadIsJustWithinRange) {
  const CoverageSettings coverage = coverage_settings(small_settings(), 4);
  EXPECT_EQ(coverage.spacing_m, 4);
  // The corner of 4 m by 4 m, 4 m ahead: sqrt(16 + 4 + 4).
  EXPECT_NEAR(coverage.sensor.range_m, std::sqrt(24), 1e-12);
}

TEST(Table1, HasThreeModelsForEachDAndTheirPaperNumbers) {
  Settings settings = small_settings();
  settings.jobs = 2;
  const Finding finding = table1(settings);
  const Table& table = finding.table;
  ASSERT_EQ(table.rows.size(), 9u);
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t rows = 3 * d, completed = rows + 1, units = rows + 2;
    const paper::Modelling& paper = paper::kModelling[d];
    EXPECT_EQ(number(table, rows, "d_m"), paper.spacing_m);
    EXPECT_EQ(text(table, rows, "model"), "slices and rows");
    EXPECT_EQ(number(table, rows, "paper_nodes"), paper.arcs);
    EXPECT_EQ(number(table, rows, "paper_s"), paper.arcs_s);
    EXPECT_EQ(number(table, units, "paper_nodes"), paper.viewpoints);
    EXPECT_EQ(number(table, units, "paper_s"), paper.units_s);
    EXPECT_TRUE(
        std::holds_alternative<std::monostate>(table.rows[completed][column(table, "paper_s")]));
    const auto covered = [&](std::size_t row) {
      return number(table, row, "covered_of_visible_percent");
    };
    EXPECT_GT(covered(completed), covered(rows));
    EXPECT_GT(covered(completed), 99);
    EXPECT_GT(number(table, units, "nodes"), number(table, completed, "nodes"));
    for (const std::size_t row : {rows, completed, units}) {
      EXPECT_GE(number(table, row, "least_clearance_m"), 1.999);
      EXPECT_LE(number(table, row, "nodes_least"), number(table, row, "nodes"));
      EXPECT_GE(number(table, row, "nodes_most"), number(table, row, "nodes"));
    }
  }
  EXPECT_EQ(finding.pictures.at(0).panels.at(0).series.size(), 5u);
}

TEST(Fig5, RowsSeeWhatSlicesAloneLeaveOut) {
  const Finding finding = fig5(small_settings());
  const Table& table = finding.table;
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(text(table, 0, "model"), "slices alone");
  for (std::size_t row = 1; row < 3; ++row)
    EXPECT_GT(number(table, row, "covered_of_visible_percent"),
              number(table, row - 1, "covered_of_visible_percent"));
  ASSERT_EQ(finding.pictures.at(0).panels.size(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    std::size_t strokes = 0;
    for (const Series& series : finding.pictures[0].panels[row].series)
      if (series.lines) strokes += series.strokes.size();
    EXPECT_EQ(static_cast<double>(strokes), number(table, row, "nodes"));
  }
}

TEST(Fig6, DrawsEveryViewpointAndTheWayThroughThem) {
  const Finding finding = fig6(small_settings());
  ASSERT_EQ(finding.table.rows.size(), 1u);
  const double nodes = number(finding.table, 0, "nodes");
  const auto& panels = finding.pictures.at(0).panels;
  EXPECT_EQ(static_cast<double>(panels.at(0).series.at(0).strokes.at(0).size()), nodes);
  // A leg to each viewpoint, the viewpoint itself, and the way home.
  EXPECT_EQ(static_cast<double>(panels.at(1).series.at(0).strokes.size()), 2 * nodes + 1);
}

}  // namespace
}  // namespace arcbid::reproduce
