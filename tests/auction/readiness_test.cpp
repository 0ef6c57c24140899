// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/readiness.hpp"

#include <gmock/gmock.h>

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;

constexpr std::uint64_t here = 11, elsewhere = 22;

TEST(Readiness, BeginsWithNobody) {
  const Readiness readiness(3, 1);
  EXPECT_FALSE(readiness.ready());
  EXPECT_THAT(readiness.set(), ElementsAre(false, false, false));
}

TEST(Readiness, CountsItselfOnceItHasDecided) {
  Readiness readiness(3, 1);
  readiness.decided(here);
  EXPECT_TRUE(readiness.ready());
  EXPECT_THAT(readiness.set(), ElementsAre(false, true, false));
}

TEST(Readiness, GrowsByWhatOthersSayOfTheSameView) {
  Readiness readiness(3, 1);
  readiness.decided(here);
  EXPECT_TRUE(readiness.heard(0, here, {true, false, false}));
  EXPECT_THAT(readiness.set(), ElementsAre(true, true, false));
  EXPECT_TRUE(readiness.heard(0, here, {true, true, true})) << "what a member passes on counts";
  EXPECT_THAT(readiness.set(), ElementsAre(true, true, true));
  EXPECT_FALSE(readiness.heard(2, here, {true, true, true})) << "nothing new";
}

TEST(Readiness, IgnoresWhatIsSaidOfAnotherView) {
  Readiness readiness(3, 1);
  readiness.decided(here);
  EXPECT_FALSE(readiness.heard(0, elsewhere, {true, true, true}));
  EXPECT_THAT(readiness.set(), ElementsAre(false, true, false));
}

TEST(Readiness, NeverForgetsAFactThatAnOldMessageDoesNotMention) {
  Readiness readiness(2, 1);
  readiness.decided(here);
  readiness.heard(0, here, {true, false});
  readiness.heard(0, here, {false, false});
  readiness.heard(0, elsewhere, {true, false});
  EXPECT_THAT(readiness.set(), ElementsAre(true, true));
}

TEST(Readiness, IsEmptiedByAChangeOfTheView) {
  Readiness readiness(3, 1);
  readiness.decided(here);
  readiness.heard(0, here, {true, false, true});
  readiness.view_changed();
  EXPECT_FALSE(readiness.ready());
  EXPECT_THAT(readiness.set(), ElementsAre(false, false, false));
  EXPECT_FALSE(readiness.heard(0, here, {true, false, true}))
      << "nothing counts before the decision";
  EXPECT_THAT(readiness.set(), ElementsAre(false, false, false));
}

TEST(Readiness, DoesNotCarryTheSetOfOneViewOverToTheNext) {
  Readiness readiness(3, 1);
  readiness.decided(here);
  readiness.heard(0, here, {true, false, true});
  readiness.view_changed();
  readiness.decided(elsewhere);
  EXPECT_THAT(readiness.set(), ElementsAre(false, true, false));
}

TEST(Readiness, CountsWhatWasHeardOfAViewBeforeItWasReached) {
  Readiness readiness(3, 1);
  readiness.heard(0, here, {true, false, false});
  readiness.heard(2, elsewhere, {false, false, true});
  readiness.decided(here);
  EXPECT_THAT(readiness.set(), ElementsAre(true, true, false));
}

TEST(Readiness, KeepsOnlyTheLatestWordOfAMember) {
  Readiness readiness(3, 1);
  readiness.heard(0, here, {true, false, false});
  readiness.heard(0, elsewhere, {true, false, false});
  readiness.decided(here);
  EXPECT_THAT(readiness.set(), ElementsAre(false, true, false));
}

}  // namespace
}  // namespace arcbid::testing
