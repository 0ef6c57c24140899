// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/error.hpp"
#include "sim/reproduce/tour_sets.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/reproduce/small.hpp"

namespace arcbid::reproduce {
namespace {

using arcbid::testing::Scratch;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

template <class Body>
std::string refusal(const Body& body) {
  try {
    body();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Pairs, AreTheNearestFirst) {
  // 0 and 1 are nearest; 2, which would have been with 1, is left with 3.
  const auto arcs = nearest_pairs({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2.5, 0, 0), Vec3(9, 0, 0)});
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].length_m, 1);
  EXPECT_EQ(arcs[1].first_m, Vec3(2.5, 0, 0));
  EXPECT_EQ(arcs[1].last_m, Vec3(9, 0, 0));
  EXPECT_EQ(arcs[1].length_m, 6.5);
}

TEST(Pairs, OfCitiesOddInNumberAreWithACityTwice) {
  const auto arcs = nearest_pairs({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(5, 0, 0)});
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].length_m, 0);
  EXPECT_EQ(arcs[0].first_m, Vec3(5, 0, 0));
}

TEST(TourSets, MissingFilesAreAllNamedButThePapersOwnSet) {
  const Scratch scratch;
  scratch.file("att48.tsp", "");
  EXPECT_THAT(
      refusal([&] { require_tsplib(scratch / ""); }),
      AllOf(HasSubstr("has no eil101.tsp, ch150.tsp"), HasSubstr("pcb442.tsp; legal"),
            HasSubstr("TSPLIB95 (G. Reinelt"), Not(HasSubstr("att48")), Not(HasSubstr("rand200"))));
}

constexpr const char* kCities = "NODE_COORD_SECTION\n1 0 0\n2 1 0\n3 0 9\n4 1 9\nEOF\n";

TEST(TourSets, HeedPairsAndTheBestKnownWhereTheyAreGiven) {
  const Scratch scratch;
  const paper::TourSet& att48 = paper::kTourSets[0];
  scratch.file("att48.tsp", kCities);
  const ArcSet nearest = arc_set(att48, scratch / "");
  EXPECT_EQ(nearest.name, "att48");
  EXPECT_EQ(nearest.arcs[0].length_m, 1);
  EXPECT_FALSE(nearest.best_known);
  scratch.file("att48.matching.pairs", "1 3\n2 4\n");
  scratch.file("arc_reference.csv",
               "name,pairing,M,arc_total,best\natt48,consecutive,2,2,7\natt48,matching,2,18,20\n");
  const ArcSet given = arc_set(att48, scratch / "");
  EXPECT_EQ(given.arcs[0].length_m, 9);
  EXPECT_EQ(given.best_known, 20);
  scratch.file("arc_reference.csv", "att48,matching,2,18,-1\n");
  EXPECT_THAT(refusal([&] { arc_set(att48, scratch / ""); }),
              HasSubstr("arc_reference.csv:1: '-1' is no length of a tour; legal"));
}

TEST(Table2, OfSetsMadeHereIsWholeAndTheSameForAnyNumberOfThreads) {
  Settings settings = small_settings();
  const Table one = table2(settings).table;
  settings.jobs = 3;
  const Table three = table2(settings).table;
  EXPECT_EQ(without_seconds(one), without_seconds(three));
  ASSERT_EQ(one.rows.size(), 9u * 5);
  for (std::size_t s = 0; s < 9; ++s) {
    const paper::TourSet& set = paper::kTourSets[s];
    double least = 1e9;
    for (std::size_t row = 5 * s; row < 5 * s + 5; ++row) {
      EXPECT_EQ(text(one, row, "set"), "rand" + std::to_string(set.cities));
      EXPECT_EQ(number(one, row, "arcs"), (set.cities + 1) / 2);
      EXPECT_EQ(text(one, row, "reference"), "best of this run");
      EXPECT_GE(number(one, row, "worst_gap_percent"), number(one, row, "gap_percent"));
      EXPECT_GE(number(one, row, "gap_percent"), 0);
      EXPECT_GT(number(one, row, "cpu_s"), 0);
      least = std::min(least, number(one, row, "gap_percent"));
    }
    EXPECT_EQ(text(one, 5 * s + 1, "solver"), "crsom+ls");
    EXPECT_LE(number(one, 5 * s + 1, "gap_percent"), number(one, 5 * s, "gap_percent"));
    EXPECT_EQ(number(one, 5 * s, "paper_gap_percent"), 100 * set.crsom.gap);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(
        one.rows[5 * s + 1][column(one, "paper_gap_percent")]));
    EXPECT_EQ(number(one, 5 * s + 4, "paper_s"), set.pso.seconds);
  }
}

TEST(Table2, GapsAreToTheBestKnown) {
  const std::string folder = std::string(ARCBID_SHARED_DATA) + "/tsplib";
  if (!std::filesystem::exists(folder + "/att48.tsp")) GTEST_SKIP() << "no " << folder;
  Settings settings = small_settings();
  settings.repeats = 1;
  settings.tsplib = folder;
  const Finding finding = table2(settings);
  EXPECT_EQ(text(finding.table, 0, "set"), "att48");
  EXPECT_EQ(text(finding.table, 0, "reference"), "best known");
  EXPECT_NEAR(number(finding.table, 0, "reference_length"), 34832.4623, 1e-3);
  for (std::size_t row = 0; row < finding.table.rows.size(); ++row)
    EXPECT_GE(number(finding.table, row, "gap_percent"), -1e-4) << row;
  for (const std::string& difference : finding.differences)
    EXPECT_THAT(difference, Not(HasSubstr("No --tsplib")));
}

}  // namespace
}  // namespace arcbid::reproduce
