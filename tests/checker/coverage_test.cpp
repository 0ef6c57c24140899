// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/checker/coverage.hpp"

#include <gmock/gmock.h>

namespace arcbid::checker {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(WhyNotTiled, AcceptsATilingInAnyOrderToTheMillimetre) {
  EXPECT_THAT(why_not_tiled({{4, 10, "b"}, {0, 4, "a"}}, 10), IsEmpty());
  EXPECT_THAT(why_not_tiled({{0.0002, 4.0002, "a"}, {4, 10.0002, "b"}}, 10), IsEmpty());
}

TEST(WhyNotTiled, NamesWhatIsMissing) {
  EXPECT_THAT(why_not_tiled({}, 10), ElementsAre(HasSubstr("10.0000 m not covered")));
  EXPECT_THAT(why_not_tiled({{1, 10, "a"}}, 10), ElementsAre(HasSubstr("before a")));
  EXPECT_THAT(why_not_tiled({{0, 9, "a"}}, 10), ElementsAre(HasSubstr("from 9.0000 to 10.0000 m")));
}

TEST(WhyNotTiled, NamesWhoCoversAgain) {
  EXPECT_THAT(
      why_not_tiled({{0, 10, "a"}, {2, 3, "b"}}, 10),
      ElementsAre(HasSubstr("1.0000 m covered twice, the longest part from 2.0000 to 3.0000 "
                            "m by a and b")));
}

TEST(WhyNotTiled, NamesWhatIsOutside) {
  EXPECT_THAT(why_not_tiled({{-1, 10, "a"}}, 10), ElementsAre(HasSubstr("outside the arc")));
  EXPECT_THAT(why_not_tiled({{0, 10, "a"}, {12, 13, "b"}}, 10),
              ElementsAre(HasSubstr("1.0000 m outside the arc")));
}

TEST(Difference, CountsWhatOnlyOneSideHas) {
  EXPECT_DOUBLE_EQ(difference_m({{0, 5, ""}, {5, 8, ""}}, {{0, 8, ""}}), 0);
  EXPECT_DOUBLE_EQ(difference_m({{0, 5, ""}}, {{3, 8, ""}}), 6);
  EXPECT_DOUBLE_EQ(difference_m({{0, 5, ""}, {1, 4, ""}}, {}), 5);
  EXPECT_DOUBLE_EQ(difference_m({}, {{1, 2, ""}, {7, 9, ""}}), 3);
}

}  // namespace
}  // namespace arcbid::checker
