// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/task_set.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

#include "tests/auction/shuffled.hpp"

namespace arcbid {

std::ostream& operator<<(std::ostream& out, const Piece& piece) {
  return out << "arc " << piece.arc.value << " [" << piece.from_m << ", " << piece.to_m << "]";
}

namespace testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint32_t plenty = 100'000;

Arc straight_arc(std::uint32_t id, double length_m) {
  const Vec3 start(0, 10.0 * id, 0);
  return {{id},
          ArcKind::outline,
          {{start, Vec3::UnitY()}, {start + Vec3(length_m, 0, 0), Vec3::UnitY()}}};
}

std::vector<Arc> straight_arcs(const std::vector<double>& lengths_m) {
  std::vector<Arc> arcs;
  for (const double length : lengths_m)
    arcs.push_back(straight_arc(static_cast<std::uint32_t>(arcs.size()), length));
  return arcs;
}

std::vector<Arc> crooked_arcs(std::uint64_t seed, std::uint32_t count) {
  Dice dice(seed);
  std::vector<Arc> arcs;
  for (std::uint32_t m = 0; m < count; ++m) {
    Arc arc{{m}, ArcKind::outline, {}};
    for (std::uint64_t w = 2 + dice.below(6); w > 0; --w)
      arc.waypoints.push_back({10 * Vec3(dice.unit(), dice.unit(), dice.unit()), Vec3::UnitX()});
    arcs.push_back(arc);
  }
  return arcs;
}

std::vector<Task> of_arc(const TaskSet& set, ArcId arc) {
  std::vector<Task> tasks;
  for (const Task& task : set.tasks)
    if (task.arc == arc) tasks.push_back(task);
  return tasks;
}

std::vector<double> lengths_of(const TaskSet& set, std::uint32_t arc) {
  std::vector<double> lengths;
  for (const Task& task : of_arc(set, {arc})) lengths.push_back(task.length_m());
  return lengths;
}

TEST(Split, CutsByTheShortestArcAndLeavesTheRemainderLast) {
  const TaskSet set = split(straight_arcs({25, 8, 16}), std::nullopt, plenty);
  EXPECT_DOUBLE_EQ(set.piece_m, 8);
  EXPECT_THAT(lengths_of(set, 0), ElementsAre(8, 8, 8, 1));
  EXPECT_THAT(lengths_of(set, 1), ElementsAre(8));
  EXPECT_THAT(lengths_of(set, 2), ElementsAre(8, 8));
  EXPECT_THAT(set.warnings, IsEmpty());
}

TEST(Split, IsNotDrivenByLinesThatFillGaps) {
  std::vector<Arc> arcs = straight_arcs({25, 1, 8});
  arcs[1].kind = ArcKind::gap;
  TaskSet set = split(arcs, std::nullopt, plenty);
  EXPECT_DOUBLE_EQ(set.piece_m, 8);
  EXPECT_THAT(lengths_of(set, 1), ElementsAre(1));
  for (Arc& arc : arcs) arc.kind = ArcKind::gap;
  set = split(arcs, std::nullopt, plenty);
  EXPECT_DOUBLE_EQ(set.piece_m, 1);
}

TEST(Split, TilesEveryArcExactly) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto arcs = crooked_arcs(seed, 8);
    const TaskSet set = split(arcs, std::nullopt, plenty);
    std::uint32_t next_id = 0;
    for (const Arc& arc : arcs) {
      const auto tasks = of_arc(set, arc.id);
      ASSERT_FALSE(tasks.empty());
      EXPECT_EQ(tasks.front().from_m, 0);
      EXPECT_EQ(tasks.back().to_m, length_m(arc.waypoints));
      EXPECT_EQ(tasks.front().first_m, arc.waypoints.front().position_m);
      EXPECT_EQ(tasks.back().last_m, arc.waypoints.back().position_m);
      double total = 0;
      for (std::size_t k = 0; k < tasks.size(); ++k) {
        EXPECT_EQ(tasks[k].id.value, next_id++);
        total += tasks[k].length_m();
        if (k + 1 == tasks.size()) break;
        EXPECT_NEAR(tasks[k].length_m(), set.piece_m, 1e-9);
        EXPECT_EQ(tasks[k].to_m, tasks[k + 1].from_m);
        EXPECT_EQ(tasks[k].last_m, tasks[k + 1].first_m) << "neighbours share the cut, bit for bit";
      }
      EXPECT_NEAR(total, length_m(arc.waypoints), 1e-9);
      EXPECT_LT(tasks.back().length_m(), set.piece_m + 1e-3);
      EXPECT_GE(tasks.back().length_m(), 1e-3);
    }
    EXPECT_EQ(next_id, set.tasks.size());
  }
}

TEST(Split, CutsWhereTheDistanceAlongTheArcSays) {
  const Arc corner{{0},
                   ArcKind::outline,
                   {{Vec3(0, 0, 0), Vec3::UnitZ()},
                    {Vec3(3, 0, 0), Vec3::UnitZ()},
                    {Vec3(3, 3, 0), Vec3::UnitZ()}}};
  const TaskSet set = split({corner}, 2.0, plenty);
  ASSERT_EQ(set.tasks.size(), 3u);
  EXPECT_EQ(set.tasks[0].last_m, Vec3(2, 0, 0));
  EXPECT_EQ(set.tasks[1].last_m, Vec3(3, 1, 0));
}

TEST(Split, LeavesASliverWithThePieceBefore) {
  EXPECT_EQ(lengths_of(split(straight_arcs({20.0009}), 10.0, plenty), 0).size(), 2u);
  EXPECT_EQ(split(straight_arcs({20.0009}), 10.0, plenty).tasks.back().to_m, 20.0009);
  EXPECT_EQ(lengths_of(split(straight_arcs({20.0011}), 10.0, plenty), 0).size(), 3u);
  EXPECT_EQ(lengths_of(split(straight_arcs({0.3}), 0.1, plenty), 0).size(), 3u) << "0.3 / 0.1 < 3";
}

TEST(Split, TakesTheGivenLengthInsteadOfTheShortestArcs) {
  const TaskSet set = split(straight_arcs({25, 8}), 10.0, plenty);
  EXPECT_DOUBLE_EQ(set.piece_m, 10);
  EXPECT_THAT(lengths_of(set, 0), ElementsAre(10, 10, 5));
  EXPECT_THAT(lengths_of(set, 1), ElementsAre(8));
}

TEST(Split, LeavesArcsWholeWhenTheLengthGivenIsLongerThanAll) {
  EXPECT_EQ(split(straight_arcs({25, 8}), 1e6, plenty).tasks.size(), 2u);
}

TEST(Split, RaisesTheLengthToKeepTheLimitAndSaysSo) {
  const auto arcs = straight_arcs({25, 0.5, 40, 13});
  ASSERT_EQ(split(arcs, std::nullopt, plenty).tasks.size(), 157u);
  const TaskSet set = split(arcs, std::nullopt, 20);
  EXPECT_LE(set.tasks.size(), 20u);
  EXPECT_GE(set.tasks.size(), 17u) << "no coarser than it has to be";
  ASSERT_EQ(set.warnings.size(), 1u);
  EXPECT_THAT(set.warnings[0], HasSubstr("157"));
  EXPECT_THAT(set.warnings[0], HasSubstr("max_tasks = 20"));
  EXPECT_THAT(split(arcs, std::nullopt, 157).warnings, IsEmpty());
}

TEST(Split, NeverMakesLessOfAnArcThanTheWhole) {
  const TaskSet set = split(straight_arcs({25, 8, 40}), 1.0, 2);
  EXPECT_EQ(set.tasks.size(), 3u);
  EXPECT_EQ(set.warnings.size(), 1u);
}

TEST(Split, SurvivesAnArcOfAMillionPieces) {
  EXPECT_LE(split(straight_arcs({1e9, 0.02}), std::nullopt, 1000).tasks.size(), 1000u);
}

TEST(Split, MakesNothingOfNothing) {
  EXPECT_THAT(split({}, std::nullopt, 10).tasks, IsEmpty());
}

TEST(Split, KnowsWhichPiecesAreOfOneArc) {
  const TaskSet set = split(straight_arcs({20, 10}), std::nullopt, plenty);
  EXPECT_TRUE(set.same_arc({0}, {1}));
  EXPECT_FALSE(set.same_arc({1}, {2}));
}

TEST(SplitDigest, IsTheSameForTheSameArcs) {
  EXPECT_EQ(split(crooked_arcs(3, 9), std::nullopt, plenty).digest,
            split(crooked_arcs(3, 9), std::nullopt, plenty).digest);
}

TEST(SplitDigest, ChangesWithTheLastBitOfEveryEnd) {
  const auto arcs = crooked_arcs(4, 5);
  const std::uint64_t digest = split(arcs, 2.0, plenty).digest;
  for (std::size_t m = 0; m < arcs.size(); ++m)
    for (const std::size_t w : {std::size_t{0}, arcs[m].waypoints.size() - 1})
      for (int axis = 0; axis < 3; ++axis) {
        auto changed = arcs;
        double& x = changed[m].waypoints[w].position_m[axis];
        x = std::nextafter(x, 1e9);
        EXPECT_NE(split(changed, 2.0, plenty).digest, digest) << m << ' ' << w << ' ' << axis;
      }
}

TEST(SplitDigest, ChangesWithThePiecesAndWithTheArcs) {
  const auto arcs = straight_arcs({20, 15});
  const std::uint64_t digest = split(arcs, 10.0, plenty).digest;
  EXPECT_NE(split(arcs, std::nextafter(10.0, 11.0), plenty).digest, digest);
  EXPECT_NE(split({arcs[0]}, 10.0, plenty).digest, digest);
  auto renamed = arcs;
  renamed[1].id = {7};
  EXPECT_NE(split(renamed, 10.0, plenty).digest, digest);
}

/// Arc 0: tasks 0 to 3, arc 1: tasks 4 to 6; ten metres each.
class Combine : public ::testing::Test {
 protected:
  std::vector<Piece> combined(const std::vector<std::uint32_t>& path) const {
    std::vector<TaskId> ids;
    for (const std::uint32_t j : path) ids.push_back({j});
    return combine(set_, ids);
  }
  TaskSet set_ = split(straight_arcs({40, 30}), 10.0, plenty);
  const ArcId a_{0}, b_{1};
};

TEST_F(Combine, JoinsARunFlownForward) {
  EXPECT_THAT(combined({0, 1, 2}), ElementsAre(Piece{a_, 0, 30}));
}

TEST_F(Combine, JoinsARunFlownBackward) {
  EXPECT_THAT(combined({3, 2, 1}), ElementsAre(Piece{a_, 10, 40}));
}

TEST_F(Combine, JoinsWholeArcsAndKeepsTheOrderOfThePath) {
  EXPECT_THAT(combined({6, 5, 4, 0, 1, 2, 3}), ElementsAre(Piece{b_, 0, 30}, Piece{a_, 0, 40}));
}

TEST_F(Combine, DoesNotJoinAcrossArcs) {
  // The end of arc 0 and the beginning of arc 1 are neighbours in the set, and 4 begins where 0
  // does.
  EXPECT_THAT(combined({3, 4}), ElementsAre(Piece{a_, 30, 40}, Piece{b_, 0, 10}));
  EXPECT_THAT(combined({0, 5}), ElementsAre(Piece{a_, 0, 10}, Piece{b_, 10, 20}));
}

TEST_F(Combine, DoesNotJoinPiecesThatArePartedOnTheArc) {
  EXPECT_THAT(combined({0, 2}), ElementsAre(Piece{a_, 0, 10}, Piece{a_, 20, 30}));
}

TEST_F(Combine, DoesNotJoinNeighboursOnTheArcThatArePartedInThePath) {
  EXPECT_THAT(combined({0, 4, 1}),
              ElementsAre(Piece{a_, 0, 10}, Piece{b_, 0, 10}, Piece{a_, 10, 20}));
}

TEST_F(Combine, DoesNotJoinAPieceToARunWhoseFarEndItTouches) {
  EXPECT_THAT(combined({1, 2, 0}), ElementsAre(Piece{a_, 10, 30}, Piece{a_, 0, 10}));
  EXPECT_THAT(combined({2, 1, 3}), ElementsAre(Piece{a_, 10, 30}, Piece{a_, 30, 40}));
}

TEST_F(Combine, OfNothingOrOneIsThat) {
  EXPECT_THAT(combined({}), IsEmpty());
  EXPECT_THAT(combined({6}), ElementsAre(Piece{b_, 20, 30}));
}

TEST(CombineRandom, ConservesLengthAndGivesWholeArcsBack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto arcs = crooked_arcs(seed, 6);
    const TaskSet set = split(arcs, 0.7, plenty);
    Dice dice(seed);
    std::vector<TaskId> in_order;
    for (const Task& task : set.tasks) in_order.push_back(task.id);
    double flown = 0, whole = 0;
    for (const Piece& piece : combine(set, shuffled(in_order, dice)))
      flown += piece.to_m - piece.from_m;
    for (const Arc& arc : arcs) whole += length_m(arc.waypoints);
    EXPECT_NEAR(flown, whole, 1e-9);
    std::vector<Piece> expected;
    for (const Arc& arc : arcs) expected.push_back({arc.id, 0, length_m(arc.waypoints)});
    EXPECT_EQ(combine(set, in_order), expected);
  }
}

}  // namespace
}  // namespace testing
}  // namespace arcbid
