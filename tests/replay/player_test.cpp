// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/player.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "core/base/error.hpp"
#include "sim/replay/moment_text.hpp"
#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::RecordedFleet;

constexpr TimeNs ms = 1'000'000, s = 1'000 * ms;

/// Three agents agree; then the third one dies, and the others agree again.
class PlayerTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    RecordedFleet fleet(testing::random_mission(3, 3, 5), folder_->path(), 3);
    ASSERT_TRUE(fleet.run(60 * s));
    fleet.kill({3});
    fleet.run_for(4 * s);
    ASSERT_TRUE(fleet.run(60 * s));
    fleet.end();
    run_ = new RunArchive(open_run(folder_->path()));
    playback_ = new Playback(*run_);
  }
  static void TearDownTestSuite() {
    delete playback_;
    delete run_;
    delete folder_;
  }
  static Player player(MomentFilter filter = {}) { return {*run_, *playback_, filter}; }
  static const Mark& mark(std::size_t moment) {
    const Moment& at = playback_->moments()[moment];
    return run_->lives[at.life].marks()[at.mark];
  }

  static testing::TemporaryFolder* folder_;
  static RunArchive* run_;
  static Playback* playback_;
};
testing::TemporaryFolder* PlayerTest::folder_ = nullptr;
RunArchive* PlayerTest::run_ = nullptr;
Playback* PlayerTest::playback_ = nullptr;

TEST_F(PlayerTest, StepsForwardAndBackOverTheSameMoments) {
  Player at = player();
  EXPECT_THAT(at.step(3), ElementsAre(0, 1, 2));
  EXPECT_EQ(at.position(), 3u);
  EXPECT_THAT(at.step(-2), ElementsAre(1, 2));
  EXPECT_EQ(at.position(), 1u);
  EXPECT_THAT(at.step(-5), ElementsAre(0));
  EXPECT_EQ(at.position(), 0u);
}

TEST_F(PlayerTest, StepsOverWhatIsNotShown) {
  Player at = player({.agent = AgentId{2}, .arc = {}, .topic = Topic::decision});
  const auto passed = at.step(1'000'000);
  std::size_t decisions = 0;
  for (const Mark& of : run_->lives[1].marks()) decisions += of.decided ? 1 : 0;
  EXPECT_EQ(passed.size(), decisions);
  for (const std::size_t moment : passed) {
    EXPECT_EQ(run_->lives[playback_->moments()[moment].life].agent(), AgentId{2});
    EXPECT_TRUE(mark(moment).decided);
  }
  EXPECT_EQ(at.step(-1).front(), passed.back());
}

TEST_F(PlayerTest, ShowsOfAnArcWhatDecidesOnItOrBringsNewsOfIt) {
  Player at = player({.agent = {}, .arc = ArcId{2}, .topic = {}});
  const auto passed = at.step(1'000'000);
  ASSERT_FALSE(passed.empty());
  EXPECT_LT(passed.size(), playback_->moments().size());
  for (const std::size_t moment : passed)
    EXPECT_TRUE(mark(moment).changed || mark(moment).learnt) << moment;
}

TEST_F(PlayerTest, PlaysByTheRateAndTheTimeThatComesIn) {
  Player at = player();
  at.set_rate(2);
  const TimeNs start_ns = at.now_ns();
  const auto passed = at.advance(50 * ms, 1'000'000);
  EXPECT_EQ(at.now_ns(), start_ns + 100 * ms);
  EXPECT_EQ(at.position(), playback_->at(start_ns + 100 * ms));
  EXPECT_EQ(passed.size(), at.position());
  EXPECT_FALSE(at.is_behind());
  EXPECT_DOUBLE_EQ(*at.real_rate(), 2.0);
}

TEST_F(PlayerTest, SaysWhatTheRateReallyWasWhereItCannotBeMet) {
  Player at = player();
  at.set_rate(1000);
  EXPECT_EQ(at.advance(1 * s, 4).size(), 4u);
  EXPECT_EQ(at.position(), 4u);
  EXPECT_TRUE(at.is_behind());
  EXPECT_LT(*at.real_rate(), 1.0);
}

TEST_F(PlayerTest, GoesAsFastAsPossibleAtRateZero) {
  Player at = player();
  at.set_rate(0);
  EXPECT_EQ(at.advance(1, 1'000'000).size(), playback_->moments().size());
  EXPECT_TRUE(at.at_end());
}

TEST_F(PlayerTest, BeginsAgainWhereItBeganWhenItLoops) {
  Player at = player();
  at.set_until("event:first conflict");
  at.seek(5);
  at.set_begin();
  at.set_loop(true);
  at.set_rate(0);
  EXPECT_EQ(at.advance(1, 1'000'000).size(), at.end() - 5);
  EXPECT_EQ(at.position(), 5u);
}

TEST_F(PlayerTest, SeeksTimesRoundsAndEvents) {
  Player at = player();
  const TimeNs middle_ns = playback_->moments()[playback_->moments().size() / 2].t_ns;
  at.seek_time(middle_ns);
  EXPECT_EQ(at.position(), playback_->at(middle_ns));
  at.seek("round:2");
  EXPECT_TRUE(mark(at.position() - 1).decided);
  EXPECT_EQ(mark(at.position() - 1).round, 2u);
  at.seek("event:agent 3 died");
  EXPECT_TRUE(mark(at.position() - 1).died);
  at.seek("event:agreement");
  EXPECT_TRUE(mark(at.position() - 1).agreed);
  at.seek("event:end");
  EXPECT_TRUE(at.at_end());
}

TEST_F(PlayerTest, FindsTheFirstConflict) {
  Player at = player();
  at.seek("event:first conflict");
  ASSERT_GT(at.position(), 0u);
  const Moment& moment = playback_->moments()[at.position() - 1];
  const LifeLog& log = run_->lives[moment.life];
  const Step step = log.step(moment.mark);
  const auto& theirs =
      std::get<Claims>(std::get<BidMessage>(step.event.what).statement.body).bundle;
  std::set<TaskId> own;
  for (std::size_t m = 0; m < moment.mark; ++m)
    if (log.marks()[m].changed) {
      own.clear();
      const Step decided = log.step(m);
      for (const Claim& claim : std::get<Claims>(decided.update.decision->body).bundle)
        own.insert(claim.task);
    }
  EXPECT_TRUE(std::any_of(theirs.begin(), theirs.end(),
                          [&](const Claim& claim) { return own.contains(claim.task); }));
}

TEST_F(PlayerTest, GoesFromEventToEventBothWays) {
  Player at = player();
  std::vector<std::size_t> forward, back;
  while (at.next_event(1)) forward.push_back(at.position());
  ASSERT_GE(forward.size(), 4u);
  EXPECT_TRUE(at.at_end());
  EXPECT_TRUE(std::is_sorted(forward.begin(), forward.end()));
  while (at.next_event(-1)) back.push_back(at.position());
  forward.pop_back();
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(back, forward);
}

TEST_F(PlayerTest, RefusesWhatIsNowhereAndNamesWhatThereIs) {
  Player at = player();
  for (const std::string where : {"event:party", "round:999", "soon", "1e99"}) try {
      at.seek(where);
      ADD_FAILURE() << where;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(where + ": is nowhere"));
      EXPECT_THAT(error.what(), HasSubstr("event:agent 3 died"));
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    }
}

/// Whatever way a moment was come to, it looks the same.
TEST_F(PlayerTest, HasWhatIsLatchedRightAfterAnySeek) {
  Player played = player(), sought = player();
  played.seek("event:agent 3 died");
  const std::size_t there = played.position();
  played.seek(0);
  played.step(static_cast<int>(there));
  sought.seek("event:end");
  sought.seek("event:agent 3 died");
  EXPECT_EQ(status_of(*run_, *playback_, played.position()),
            status_of(*run_, *playback_, sought.position()));
  EXPECT_THAT(status_of(*run_, *playback_, there), HasSubstr("5 arcs"));
  EXPECT_THAT(status_of(*run_, *playback_, there), HasSubstr("dead: 3;"));
  EXPECT_THAT(status_of(*run_, *playback_, there - 1), HasSubstr("dead: nobody;"));
}

TEST_F(PlayerTest, TellsWhoseTasksChangedTheirOwners) {
  Player at = player({.agent = AgentId{1}, .arc = {}, .topic = Topic::decision});
  const auto first = at.step(1);
  ASSERT_EQ(first.size(), 1u);
  const auto lines = text_of(*run_, *playback_, first[0]);
  ASSERT_GE(lines.size(), 2u);
  EXPECT_THAT(lines[0], HasSubstr("agent 1: "));
  EXPECT_THAT(lines[0], HasSubstr("round 1: decides anew"));
  EXPECT_THAT(lines[1], HasSubstr("-> agent 1: "));
}

}  // namespace
}  // namespace arcbid
