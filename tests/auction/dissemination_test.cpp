// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/dissemination.hpp"

#include <gmock/gmock.h>

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Dissemination::Timing timing{.resend_ns = 40, .patience_ns = 100};
constexpr TimeNs surely = 2 * timing.patience_ns;  // patience and its spread are over by then
constexpr std::size_t self = 0, second = 1, third = 2;

/// Agent 1 of three, and what it holds.
class DisseminationTest : public ::testing::Test {
 protected:
  void learn(std::size_t member, StatementKey key, TimeNs now) {
    view.merge({view.roster()[member], key, Claims{}});
    dissemination.learnt(member, now);
  }
  /// `member` says in its `sequence`-th status that it holds just what the view holds, but for
  /// `missing`.
  void confirms(std::size_t member, std::uint64_t sequence, std::vector<std::size_t> missing = {},
                std::uint64_t life = 7) {
    std::vector<Dissemination::Holding> holdings;
    for (std::size_t k = 0; k < 3; ++k) holdings.push_back({k, view.key(k)});
    for (const std::size_t m : missing) holdings[m].key = {};
    dissemination.holds(member, {life, sequence}, true, holdings);
  }
  std::vector<std::size_t> due(TimeNs now) { return dissemination.due(view, now); }
  bool lacking() const { return dissemination.anyone_lacks(view); }

  View view{{{1}, {2}, {3}}};
  Dissemination dissemination{3, self, timing};
  const StatementKey first{7, false, 1}, later{7, false, 2}, tombstone{7, true, 1};
};

TEST_F(DisseminationTest, IsSilentAboutNothing) {
  EXPECT_THAT(due(1000), IsEmpty());
  EXPECT_FALSE(lacking());
}

TEST_F(DisseminationTest, SaysItsOwnStatementAtOnceAndOnce) {
  learn(self, first, 0);
  EXPECT_THAT(due(0), ElementsAre(self));
  EXPECT_THAT(due(1000), IsEmpty()) << "nobody is known to lack it";
}

TEST_F(DisseminationTest, SaysItsOwnStatementAgainUntilEverybodyConfirmed) {
  learn(self, first, 0);
  due(0);
  confirms(second, 1);
  confirms(third, 1, {self});
  EXPECT_TRUE(lacking());
  EXPECT_THAT(due(timing.resend_ns - 1), IsEmpty());
  EXPECT_THAT(due(timing.resend_ns), ElementsAre(self));
  EXPECT_THAT(due(2 * timing.resend_ns - 1), IsEmpty());
  EXPECT_THAT(due(2 * timing.resend_ns), ElementsAre(self));
  confirms(third, 2);
  EXPECT_FALSE(lacking());
  EXPECT_THAT(due(1000), IsEmpty());
}

TEST_F(DisseminationTest, SaysANewStatementAtOnceWhateverWasSaidBefore) {
  learn(self, first, 0);
  due(0);
  learn(self, later, 1);
  EXPECT_THAT(due(1), ElementsAre(self));
}

TEST_F(DisseminationTest, RelaysWhoeverSaysSomethingNewAllTheTime) {
  std::vector<TimeNs> relayed;
  for (std::uint32_t version = 1; version <= 50; ++version) {
    const TimeNs now = version * timing.patience_ns / 10;
    learn(second, {7, false, version}, now);
    confirms(third, version, {second});
    if (!due(now).empty()) relayed.push_back(now);
  }
  ASSERT_GE(relayed.size(), 2u);
  EXPECT_GE(relayed[1] - relayed[0], timing.patience_ns) << "patience anew";
}

TEST_F(DisseminationTest, BeginsItsPatienceAnewWhereNobodyLackedTheStatementBefore) {
  learn(second, first, 0);
  confirms(third, 1);
  EXPECT_THAT(due(1), IsEmpty());
  learn(second, later, 1000);
  confirms(third, 2, {second});
  EXPECT_THAT(due(1000 + timing.patience_ns - 1), IsEmpty()) << "its author comes first";
}

TEST_F(DisseminationTest, RelaysOnlyAfterPatience) {
  learn(second, first, 500);
  confirms(third, 1, {second});
  EXPECT_TRUE(lacking());
  EXPECT_THAT(due(500 + timing.patience_ns - 1), IsEmpty()) << "its author comes first";
  EXPECT_THAT(due(500 + surely), ElementsAre(second));
  EXPECT_THAT(due(500 + surely + timing.patience_ns - 1), IsEmpty()) << "patience anew";
  EXPECT_THAT(due(500 + 2 * surely), ElementsAre(second));
}

TEST_F(DisseminationTest, DoesNotRelayWhatTheAuthorDelivered) {
  learn(second, first, 500);
  confirms(third, 1, {second});
  due(500 + timing.patience_ns - 1);
  confirms(third, 2);
  EXPECT_THAT(due(500 + surely), IsEmpty());
}

TEST_F(DisseminationTest, DoesNotRelayToTheAuthorItselfNorToTheUnheard) {
  learn(second, first, 0);
  confirms(second, 1, {second});
  EXPECT_FALSE(lacking());
  EXPECT_THAT(due(1000), IsEmpty());
}

TEST_F(DisseminationTest, DoesNotRelayToTheSilent) {
  learn(second, first, 0);
  confirms(third, 1, {second});
  dissemination.forget(third);
  learn(third, tombstone, 0);
  confirms(second, 1, {third});
  EXPECT_THAT(due(0), ElementsAre(third)) << "nobody but relays speaks for the dead";
  confirms(second, 2);
  EXPECT_FALSE(lacking());
  EXPECT_THAT(due(1000), IsEmpty());
}

TEST_F(DisseminationTest, ServesTheDeadWhoIsHeard) {
  learn(self, first, 0);
  due(0);
  learn(third, tombstone, 0);
  due(0);
  confirms(second, 1);
  confirms(third, 1, {self});
  EXPECT_THAT(due(timing.resend_ns), ElementsAre(self))
      << "else two sides that buried each other would wait for ever";
}

TEST_F(DisseminationTest, HasNothingForSomebodyWhoHoldsMore) {
  learn(second, first, 0);
  dissemination.holds(third, {7, 1}, true, {{second, later}});
  EXPECT_FALSE(lacking());
}

TEST_F(DisseminationTest, AddsWhatIsNewToWhatItKnowsOfAReader) {
  learn(self, first, 0);
  due(0);
  learn(second, first, 0);
  dissemination.holds(third, {7, 1}, true, {{self, first}});
  EXPECT_TRUE(lacking());
  dissemination.holds(third, {7, 2}, false, {{second, first}});
  EXPECT_FALSE(lacking()) << "the rest is as it was";
  dissemination.holds(third, {8, 1}, false, {{second, first}});
  EXPECT_TRUE(lacking()) << "a new life holds only what it says";
}

TEST_F(DisseminationTest, RelaysATombstoneAtOnce) {
  learn(second, first, 0);
  confirms(third, 1);
  learn(second, tombstone, 300);
  EXPECT_THAT(due(300), ElementsAre(second));
  EXPECT_THAT(due(301), IsEmpty()) << "once; then with patience";
  EXPECT_THAT(due(300 + surely), ElementsAre(second));
}

TEST_F(DisseminationTest, TellsTheBuriedOnceInCaseItLives) {
  learn(second, first, 0);
  confirms(second, 1);
  confirms(third, 1);
  learn(second, tombstone, 300);
  confirms(third, 2);  // only the dead member itself lacks its tombstone
  EXPECT_THAT(due(300), ElementsAre(second));
  EXPECT_FALSE(lacking());
  EXPECT_THAT(due(5000), IsEmpty());
}

TEST_F(DisseminationTest, BelievesTheLatestStatusNotTheLastToArrive) {
  learn(second, first, 0);
  confirms(third, 5);
  confirms(third, 4, {second});  // reordered
  EXPECT_FALSE(lacking());
  confirms(third, 5, {second});  // duplicated with the number of another
  EXPECT_FALSE(lacking());
}

TEST_F(DisseminationTest, KnowsThatARebornMemberLostWhatItHeld) {
  learn(self, first, 0);
  learn(second, first, 0);
  due(0);
  confirms(third, 900);
  EXPECT_FALSE(lacking());
  confirms(third, 1, {self, second}, 8);  // a new life, its first word
  EXPECT_TRUE(lacking());
  EXPECT_THAT(due(1000), ElementsAre(self, second));
}

TEST(DisseminationSpread, LetsHoldersRelayAtDifferentMoments) {
  std::vector<TimeNs> moments;
  for (const std::size_t holder : {0, 1, 2, 3, 4, 5}) {
    View view({{1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}});
    Dissemination dissemination(8, holder, {.resend_ns = 40, .patience_ns = 1'000'000});
    view.merge({{7}, {7, false, 1}, Claims{}});
    dissemination.learnt(6, 0);
    dissemination.holds(7, {7, 1}, true, {});
    TimeNs now = 1'000'000;
    while (dissemination.due(view, now).empty() && now <= 2'000'000) now += 1000;
    EXPECT_LE(now, 2'000'000);
    moments.push_back(now);
  }
  std::sort(moments.begin(), moments.end());
  EXPECT_EQ(std::adjacent_find(moments.begin(), moments.end()), moments.end());
}

}  // namespace
}  // namespace arcbid::testing
