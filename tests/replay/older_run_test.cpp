// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of an arcbid whose records are laid out otherwise: they play as they did, are not verified,
// and it is said why.
#include "agent/recorded_messages.hpp"
#include "sim/replay/counterfactual.hpp"
#include "sim/replay/playback.hpp"
#include "sim/replay/salvage.hpp"
#include "sim/replay/verify.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/record/other_build.hpp"
#include "tests/replay/older_run_fixture.hpp"

namespace arcbid::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(OlderRun, PlaysAsItDid) {
  age();
  const RunArchive before = open_run(was), after = open_run(run);
  ASSERT_EQ(after.lives.size(), before.lives.size());
  const Playback a(before), b(after);
  ASSERT_EQ(b.moments().size(), a.moments().size());
  ASSERT_GT(a.moments().size(), 100u);
  for (std::size_t m = 0; m <= a.moments().size(); ++m) {
    ASSERT_EQ(b.owners(m), a.owners(m)) << m;
    if (m == a.moments().size()) continue;
    ASSERT_EQ(b.moments()[m].life, a.moments()[m].life) << m;
    ASSERT_EQ(b.moments()[m].mark, a.moments()[m].mark) << m;
  }
  for (std::size_t l = 0; l < before.lives.size(); ++l) {
    EXPECT_FALSE(after.lives[l].damage()) << *after.lives[l].damage();
    const auto routes = before.lives[l].routes(), again = after.lives[l].routes();
    ASSERT_EQ(again.size(), routes.size());
    for (std::size_t r = 0; r < routes.size(); ++r) {
      EXPECT_EQ(again[r].route.length_m, routes[r].route.length_m);
      EXPECT_EQ(again[r].route.legs.size(), routes[r].route.legs.size());
    }
  }
}

TEST_F(OlderRun, IsNotVerifiedAndSaysWhy) {
  age();
  const RunArchive archive = open_run(run);
  const auto names_it =
      AllOf(HasSubstr(": plays, but cannot be verified: written by arcbid 0.0.9 01dbeef, this is "),
            HasSubstr("mission: AuctionSettings.audit_bids is not there"),
            HasSubstr("birth: Birth.agent is uint8, here uint32, Birth.spare is not known here"),
            HasSubstr("Header.sequence is uint32, here uint64"),
            HasSubstr("Header.task_digest is not there"),
            HasSubstr("Claim.note is not known here, Claim has its fields in another order"),
            HasSubstr("route: Route.crsom_m is not there"));
  const std::string problem = problem_of([&] { verify(archive.lives[1]); });
  EXPECT_THAT(problem, names_it);
  EXPECT_THAT(problem, HasSubstr(log.filename().string()));
  EXPECT_EQ(problem.find('\n'), std::string::npos);
  EXPECT_THAT(unverifiable(archive), ElementsAre(names_it));
  EXPECT_THAT(unverifiable(archive)[0], HasSubstr("agent_1.1001.sqlite and 2 more: "));
  EXPECT_TRUE(unverifiable(open_run(was)).empty());
}

TEST_F(OlderRun, OfAnArcbidThatOnlyHadAnotherNumberIsVerified) {
  age([](const std::string&, std::string schema) { return schema; });
  const RunArchive archive = open_run(run);
  EXPECT_TRUE(unverifiable(archive).empty());
  EXPECT_FALSE(verify(archive.lives[1]).divergence);
  EXPECT_EQ(verify(archive.lives[1]).steps, archive.lives[1].marks().size());
}

TEST_F(OlderRun, IsWholeForTheDoctorWhoSaysWhatItIs) {
  age();
  const RunReport report = examine(run);
  EXPECT_TRUE(report.whole()) << describe(report);
  EXPECT_EQ(report.logs[1].records, examine(was).logs[1].records);
  EXPECT_THAT(describe(report),
              HasSubstr("    plays, but cannot be verified: written by arcbid 0.0.9 01dbeef"));
  EXPECT_THAT(to_json(report)["logs"][1]["other_schema"].get<std::string>(),
              HasSubstr("Header.task_digest is not there"));
  EXPECT_TRUE(to_json(examine(was))["logs"][1]["other_schema"].is_null());
}

TEST_F(OlderRun, IsExplainedButNotRunAgain) {
  age();
  const RunArchive archive = open_run(run), before = open_run(was);
  const Playback playback(archive), playback_before(before);
  Explainer explainer(archive, playback), of_before(before, playback_before);
  std::size_t drops = 0;
  for (std::uint32_t j = 0; j < archive.tasks.tasks.size(); ++j) {
    const auto &story = explainer.explain(TaskId{j}), &story_before = of_before.explain(TaskId{j});
    ASSERT_EQ(story.size(), story_before.size());
    for (std::size_t n = 0; n < story.size(); ++n) EXPECT_EQ(story[n].text, story_before[n].text);
    const Explanation* drop = decisive_drop(story);
    if (!drop || !drop->source) continue;
    ++drops;
    EXPECT_THAT(problem_of([&] { without_message(archive, *drop); }),
                HasSubstr("cannot be verified"));
  }
  EXPECT_GT(drops, 0u);
}

TEST_F(OlderRun, DoesNotPlayByASchemaThatIsNone) {
  age([](const std::string& kind, std::string schema) {
    return kind == "step" ? otherwise(kind, schema) : schema;
  });
  std::string bytes = bytes_of(log);
  const auto at = bytes.find("string note");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 6, "strong");
  put_bytes(log, bytes);
  EXPECT_THAT(
      open_run(run).unreadable,
      ElementsAre(AllOf(HasSubstr("written by arcbid 0.0.9 01dbeef"),
                        HasSubstr("step: its schema cannot be read: its line \"strong\""))));
  const RunReport report = examine(run);
  EXPECT_THAT(describe(report), HasSubstr("    does not play: written by arcbid 0.0.9"));
  EXPECT_FALSE(report.whole());
  EXPECT_TRUE(report.logs[0].whole()) << describe(report);
  EXPECT_TRUE(report.logs[1].lost.empty()) << "its records may be as they were";
  EXPECT_FALSE(report.logs[1].heard_only);
  Launched doctor({"doctor", run});
  EXPECT_EQ(doctor.wait_for_end(60), 1) << doctor.output();
  salvage(run, report, folder / "salvaged");
  const RunArchive salvaged = open_run(folder / "salvaged");
  ASSERT_EQ(salvaged.lives.size(), 3u) << "the schema is another log's";
  EXPECT_EQ(salvaged.lives[1].marks().size(), open_run(was).lives[1].marks().size());
  EXPECT_TRUE(examine(folder / "salvaged").whole());
}

TEST_F(OlderRun, IsNotSaidAgainWhereItsMissionIsNone) {
  age();
  Mission damaged = random_mission(4, 3, 20);
  damaged.fleet[1].id = damaged.fleet[0].id;
  const std::vector<RecordKind> kinds = RunLogReader(log).kinds();
  for (const RecordKind& kind : kinds)
    if (kind.name == "mission")
      put_record(log, 1, OtherBuild::encode(damaged, StoredSchema(kind.schema)));
  const RecordedMessages messages(run);
  EXPECT_THAT(messages.left_out(),
              ElementsAre(HasSubstr("record 1: mission: agent 2 of its fleet is none")));
  EXPECT_EQ(messages.fleet().size(), 3u);
}

TEST_F(OlderRun, DoesNotCrashWhateverByteIsFlipped) {
  age();
  const std::string whole = bytes_of(log);
  Dice dice(11);
  for (int n = 0; n < 60; ++n) {
    std::string damaged = whole;
    const std::size_t at = dice.below(whole.size());
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << dice.below(8)));
    put_bytes(log, damaged);
    EXPECT_NO_THROW(examine(run)) << at;
    problem_of([&] {
      const RunArchive archive = open_run(run);
      const Playback playback(archive);
      playback.owners(playback.moments().size());
    });
    problem_of([&] { RecordedMessages{run}; });
  }
}

}  // namespace
}  // namespace arcbid::testing
