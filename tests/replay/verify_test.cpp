// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/verify.hpp"

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <functional>

#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using ::testing::HasSubstr;
using testing::RecordedFleet;

constexpr TimeNs s = 1'000'000'000;

/// Writes a record's body anew.
void overwrite(const std::filesystem::path& file, std::int64_t seq, const std::string& body) {
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
  sqlite3_stmt* change = nullptr;
  ASSERT_EQ(
      sqlite3_prepare_v2(db, "UPDATE events SET body = ? WHERE seq = ?", -1, &change, nullptr),
      SQLITE_OK);
  sqlite3_bind_blob(change, 1, body.data(), static_cast<int>(body.size()), SQLITE_TRANSIENT);
  sqlite3_bind_int64(change, 2, seq);
  EXPECT_EQ(sqlite3_step(change), SQLITE_DONE);
  EXPECT_EQ(sqlite3_changes(db), 1);
  sqlite3_finalize(change);
  sqlite3_close(db);
}

class VerifyTest : public ::testing::TestWithParam<PolicyKind> {
 protected:
  void SetUp() override {
    Mission mission = testing::random_mission(5, 3, 6);
    mission.auction.policy = GetParam();
    RecordedFleet fleet(mission, folder_.path(), 5);
    ASSERT_TRUE(fleet.run(60 * s));
    fleet.kill({3});
    fleet.end();
  }
  RunArchive opened() const { return open_run(folder_.path()); }

  /// The nth step of an agent's life that `is` what is looked for.
  static std::size_t find(const LifeLog& life, const std::function<bool(const Mark&)>& is) {
    for (std::size_t m = 0; m < life.marks().size(); ++m)
      if (is(life.marks()[m])) return m;
    ADD_FAILURE() << "there is no such step";
    return 0;
  }
  /// Tampers with one step of agent 2 and returns what is found then.
  Divergence found_after(const std::function<bool(const Mark&)>& where,
                         const std::function<void(Step&)>& tamper) {
    {
      const RunArchive run = opened();
      const LifeLog& life = run.lives[1];
      mark_ = find(life, where);
      Step step = life.step(mark_);
      tamper(step);
      record_ = life.marks()[mark_].seq;
      overwrite(life.file(), record_, encode(step));
    }
    const RunArchive run = opened();
    EXPECT_FALSE(verify(run.lives[0]).divergence) << "nobody touched it";
    const LifeVerdict verdict = verify(run.lives[1]);
    EXPECT_TRUE(verdict.divergence);
    return verdict.divergence.value_or(Divergence{});
  }

  testing::TemporaryFolder folder_;
  std::size_t mark_ = 0;
  std::int64_t record_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Policies, VerifyTest,
                         ::testing::Values(PolicyKind::claims, PolicyKind::cbba));

bool decided_anew(const Mark& mark) {
  return mark.decided && mark.changed && mark.round > 1;
}

TEST_P(VerifyTest, FindsNothingInWhatNobodyTouched) {
  const RunArchive run = opened();
  for (const LifeLog& life : run.lives) {
    const LifeVerdict verdict = verify(life);
    EXPECT_FALSE(verdict.divergence);
    EXPECT_EQ(verdict.steps, life.marks().size());
    EXPECT_GT(verdict.steps, 0u);
  }
}

TEST_P(VerifyTest, HoldsTheLogOfAKilledAgentToWhatIsOnRecord) {
  const RunArchive run = opened();
  EXPECT_EQ(run.lives[2].agent(), AgentId{3});
  EXPECT_EQ(run.lives[2].ended_by(), "");
  EXPECT_FALSE(verify(run.lives[2]).divergence);
}

TEST_P(VerifyTest, FindsABidThatWasChanged) {
  double was = 0, is = 0;
  TaskId task;
  const Divergence found = found_after(decided_anew, [&](Step& step) {
    StatementBody& body = step.update.decision->body;
    if (auto* claims = std::get_if<Claims>(&body)) {
      task = claims->bundle[0].task;
      was = std::exchange(claims->bundle[0].bid, claims->bundle[0].bid + 1);
      is = was + 1;
      return;
    }
    std::vector<Belief>& beliefs = std::get<Table>(body).beliefs;
    task = {1};
    was = std::exchange(beliefs[1].bid, beliefs[1].bid + 1);
    is = was + 1;
  });
  EXPECT_EQ(found.agent, AgentId{2});
  EXPECT_EQ(found.record, record_);
  const RunArchive run = opened();
  EXPECT_EQ(found.round, run.lives[1].marks()[mark_].round);
  ASSERT_TRUE(found.arc);
  EXPECT_EQ(*found.arc, run.tasks.tasks[task.value].arc);
  EXPECT_THAT(found.what, HasSubstr(".bid"));
  EXPECT_THAT(found.what, HasSubstr("the log has " + nlohmann::json(is).dump()));
  EXPECT_THAT(found.what, HasSubstr("the replay " + nlohmann::json(was).dump()));
  EXPECT_THAT(describe(found), HasSubstr("agent 2, round "));
}

TEST_P(VerifyTest, FindsAStopOfThePathThatWasTurned) {
  const Divergence found = found_after(decided_anew, [](Step& step) {
    PathStop& stop = step.update.decision->path.at(0);
    stop.reversed = !stop.reversed;
  });
  EXPECT_EQ(found.record, record_);
  EXPECT_THAT(found.what, HasSubstr("path.0.reversed"));
  EXPECT_TRUE(found.arc);
}

TEST_P(VerifyTest, FindsMessagesThatChangedPlaces) {
  {
    const RunArchive run = opened();
    const LifeLog& life = run.lives[1];
    // A statement, and a status that came after the decision that the statement led to.
    std::optional<std::size_t> first, second;
    bool has_decided = false;
    for (std::size_t m = 0; m < life.marks().size() && !second; ++m) {
      const Mark& mark = life.marks()[m];
      has_decided = first && (has_decided || mark.changed);
      if (!has_decided && mark.event == 1 && mark.learnt) first = m;
      if (has_decided && mark.event == 3) second = m;
    }
    ASSERT_TRUE(second);
    Step a = life.step(*first), b = life.step(*second);
    std::swap(a.event.what, b.event.what);
    overwrite(life.file(), life.marks()[*first].seq, encode(a));
    overwrite(life.file(), life.marks()[*second].seq, encode(b));
    record_ = life.marks()[*first].seq;
    EXPECT_NE(life.marks()[*first].heard->sequence, life.marks()[*second].heard->sequence);
  }
  const RunArchive run = opened();
  const LifeVerdict verdict = verify(run.lives[1]);
  ASSERT_TRUE(verdict.divergence);
  EXPECT_GE(verdict.divergence->record, record_);
  EXPECT_FALSE(verify(run.lives[0]).divergence);
}

}  // namespace
}  // namespace arcbid
