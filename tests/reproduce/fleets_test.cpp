// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/fleets.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "sim/auction/spread.hpp"
#include "tests/reproduce/small.hpp"

namespace arcbid::reproduce {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Fleets, FlyEveryMetreOfEveryArcByEveryMethod) {
  const BridgeArcs bridge = make_arcs(small_settings(), RowSide::long_side, 1);
  double all_m = 0;
  for (const Arc& arc : bridge.arcs) all_m += length_m(arc.waypoints);
  Method limited = kScCbba;
  limited.is_limited = true;
  for (const Method& method : {kCbba, kScCbba, limited, kOurs}) {
    const FleetRun run = divide(bridge, 3, method, 1);
    EXPECT_TRUE(run.converged && run.agreed) << method.name;
    EXPECT_EQ(run.unassigned, 0u) << method.name;
    EXPECT_NEAR(sum(metres_of_arcs(run)), all_m, 1e-6) << method.name;
    std::size_t tasks = 0;
    for (const std::size_t count : run.flown_tasks) tasks += count;
    EXPECT_EQ(tasks, run.tasks) << method.name;
    if (method.name == kCbba.name) {
      EXPECT_EQ(run.tasks, bridge.arcs.size());
    }
    for (const std::size_t count : run.flown_tasks)
      EXPECT_LE(count, method.is_limited ? (run.tasks + 2) / 3 : run.tasks);
  }
}

TEST(Fleets, WhatIsFlownOfAPieceInPartCountsInPart) {
  TaskSet pieces;
  pieces.tasks = {{{0}, {0}, 0, 4}, {{1}, {0}, 4, 6}, {{2}, {1}, 0, 4}};
  FleetRun run;
  run.routes = {{{0, 5, 0}}, {{1, 0, 4}, {0, 5, 6}}};
  // The first: a whole piece and half of one, flown backwards. The second: the rest.
  EXPECT_EQ(pieces_flown(run, pieces), (std::vector{1.5, 1.5}));
}

TEST(Fleets, RowsOfTheUnevenArcsRunAlongTheLongSide) {
  const auto longest_row_m = [](RowSide rows) {
    double longest_m = 0;
    for (const Arc& arc : make_arcs(small_settings(), rows, 1).arcs)
      if (arc.kind == ArcKind::top_row) longest_m = std::max(longest_m, length_m(arc.waypoints));
    return longest_m;
  };
  // The bridge is 60 m by 12 m.
  EXPECT_LT(longest_row_m(RowSide::short_side), 12);
  EXPECT_GT(longest_row_m(RowSide::long_side), 48);
}

TEST(Fig7, HasTwoMethodsForEachFleet) {
  const Finding finding = fig7(small_settings());
  ASSERT_EQ(finding.table.rows.size(), 8u);
  for (std::size_t row = 0; row < 8; ++row) {
    EXPECT_EQ(number(finding.table, row, "agents"), 3 + row / 2);
    EXPECT_GE(number(finding.table, row, "most_arc_m"), number(finding.table, row, "least_arc_m"));
    // By chance it would be 1/N.
    EXPECT_GT(number(finding.table, row, "near_home_percent"),
              100 / number(finding.table, row, "agents"));
  }
  ASSERT_EQ(finding.pictures.at(0).panels.size(), 4u);
  EXPECT_EQ(finding.pictures[0].panels[1].series.size(), 2 * 4u);
}

class Fig8 : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    Settings settings = small_settings();
    settings.jobs = 2;
    finding_ = new Finding(fig8(settings));
  }
  static void TearDownTestSuite() { delete finding_; }
  const Table& table() const { return finding_->table; }
  double mean(const char* arcs, const char* method, const char* name) const {
    double total = 0, count = 0;
    for (std::size_t row = 0; row < table().rows.size(); ++row)
      if (text(table(), row, "arcs") == arcs && text(table(), row, "method") == method) {
        total += number(table(), row, name);
        ++count;
      }
    EXPECT_EQ(count, 9) << "N = 2 to 10";
    return total / count;
  }
  inline static Finding* finding_ = nullptr;
};

TEST_F(Fig8, IsWholeAndAgreed) {
  ASSERT_EQ(table().rows.size(), 2u * 9 * 6);
  for (std::size_t row = 0; row < table().rows.size(); ++row) {
    EXPECT_EQ(text(table(), row, "is_agreed"), "yes") << row;
    for (const char* name : {"uniformity_pieces", "uniformity_tasks", "uniformity_time"}) {
      EXPECT_GT(number(table(), row, name), 0);
      EXPECT_LE(number(table(), row, name), 1);
    }
  }
  for (const Panel& panel : finding_->pictures.at(0).panels) {
    EXPECT_EQ(panel.series.size(), 6u);
    for (const Series& series : panel.series) EXPECT_EQ(series.strokes.at(0).size(), 9u);
  }
}

TEST_F(Fig8, PiecesAreDividedMoreEvenlyThanUnevenArcs) {
  EXPECT_GT(mean("uneven", "SC-CBBA, bundle limit", "uniformity_pieces"),
            mean("uneven", "CBBA", "uniformity_pieces"));
  EXPECT_GT(mean("uneven", "CBBA", "cv_time_percent"),
            mean("uneven", "SC-CBBA", "cv_time_percent"));
}

TEST_F(Fig8, TheLimitEvensCountsAndCostsTime) {
  EXPECT_GT(mean("even", "SC-CBBA, bundle limit", "uniformity_tasks"),
            mean("even", "SC-CBBA", "uniformity_tasks"));
  EXPECT_GT(mean("even", "SC-CBBA, bundle limit", "makespan_s"),
            mean("even", "ours", "makespan_s"));
}

TEST_F(Fig8, ExchangesLevelFlightTimes) {
  for (const char* arcs : {"even", "uneven"})
    EXPECT_LT(mean(arcs, "ours", "cv_time_percent"), mean(arcs, "SC-CBBA", "cv_time_percent"));
}

TEST(Fig10, PartsOfThePlanningAddUp) {
  const Finding finding = fig10(small_settings());
  const Table& table = finding.table;
  ASSERT_EQ(table.rows.size(), 8u);
  for (std::size_t row = 0; row < 8; ++row) {
    double parts_s = 0;
    for (const char* part : {"arcs_cpu_s", "auction_cpu_s", "exchanges_cpu_s", "tours_cpu_s"})
      parts_s += number(table, row, part);
    EXPECT_NEAR(number(table, row, "planned_cpu_s"), parts_s, 1e-9);
    EXPECT_EQ(number(table, row, "paper_mean_s"), 29.019);
  }
  // A way out and one home: each route is one stroke that begins and ends there.
  for (const Panel& panel : finding.pictures.at(0).panels)
    for (std::size_t s = 0; s < panel.series.size(); s += 2) {
      const auto& way = panel.series[s].strokes.at(0);
      EXPECT_EQ(way.front().x, way.back().x);
      EXPECT_EQ(way.front().y, panel.series[s + 1].strokes.at(0).at(0).y);
    }
}

TEST(Fig11, MoreUavsTakeLessTime) {
  Settings settings = small_settings();
  const Finding one = fig11(settings);
  const Table& table = one.table;
  ASSERT_EQ(table.rows.size(), 12u);
  for (std::size_t row = 0; row < 12; ++row) {
    const double median = number(table, row, "mission_median_s");
    EXPECT_LE(number(table, row, "mission_lower_quartile_s"), median);
    EXPECT_GE(number(table, row, "mission_upper_quartile_s"), median);
    if (row >= 2) {
      EXPECT_LT(median, number(table, row - 2, "mission_median_s")) << row;
    }
  }
  settings.jobs = 2;
  EXPECT_EQ(without_seconds(table), without_seconds(fig11(settings).table));
}

}  // namespace
}  // namespace arcbid::reproduce
