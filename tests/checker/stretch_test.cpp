// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "sim/checker/geometry.hpp"

namespace arcbid::checker {
namespace {

using testing::HasSubstr;

const Point kEast{1, 0, 0}, kNorth{0, 1, 0};

/// A square of 4 m a side that ends where it began; its last side looks north.
const Path kSquare{{{0, 0, 0}, kEast},
                   {{4, 0, 0}, kEast},
                   {{4, 4, 0}, kEast},
                   {{0, 4, 0}, kNorth},
                   {{0, 0, 0}, kNorth}};

TEST(Stretch, WholeClosedArcBothWays) {
  EXPECT_EQ(why_not_the_stretch(kSquare, kSquare, 0, 16), "");
  Path backwards = kSquare;
  std::ranges::reverse(backwards);
  EXPECT_EQ(why_not_the_stretch(backwards, kSquare, 16, 0), "");
  EXPECT_THAT(why_not_the_stretch(backwards, kSquare, 0, 16), HasSubstr("looks along"));
}

TEST(Stretch, CutsOnAWaypointAndJustBesideIt) {
  const Path second{kSquare[1], kSquare[2]};
  EXPECT_EQ(why_not_the_stretch(second, kSquare, 4, 8), "");
  // Half a millimetre before a corner where the look turns, with and without the corner itself.
  const Path third{{{0.0005, 4, 0}, kEast}, kSquare[3], {{0, 2, 0}, kNorth}};
  EXPECT_EQ(why_not_the_stretch(third, kSquare, 11.9995, 14), "");
  EXPECT_NE(why_not_the_stretch({third[0], third[2]}, kSquare, 11.9995, 14), "");
}

TEST(Stretch, InsideOneSegment) {
  const Path piece{{{1, 0, 0}, kEast}, {{3, 0, 0}, kEast}};
  EXPECT_EQ(why_not_the_stretch(piece, kSquare, 1, 3), "");
  EXPECT_THAT(why_not_the_stretch(piece, kSquare, 1, 3.002), HasSubstr("does not reach"));
  EXPECT_THAT(why_not_the_stretch(piece, kSquare, 0.998, 3), HasSubstr("it begins at"));
}

TEST(Stretch, GoingBackAndForthIsRefused) {
  const Path wavering{
      {{1, 0, 0}, kEast}, {{2, 0, 0}, kEast}, {{1.5, 0, 0}, kEast}, {{3, 0, 0}, kEast}};
  EXPECT_THAT(why_not_the_stretch(wavering, kSquare, 1, 3), HasSubstr("goes back"));
}

TEST(Stretch, GoingOnPastItsEndIsRefused) {
  Path beyond{{{1, 0, 0}, kEast}, {{3, 0, 0}, kEast}, {{3.5, 0, 0}, kEast}};
  EXPECT_THAT(why_not_the_stretch(beyond, kSquare, 1, 3), HasSubstr("past its end"));
}

TEST(Stretch, AClosedArcCannotBeSkipped) {
  const Path hovering{kSquare[0], kSquare[4]};
  EXPECT_NE(why_not_the_stretch(hovering, kSquare, 0, 16), "");
}

}  // namespace
}  // namespace arcbid::checker
