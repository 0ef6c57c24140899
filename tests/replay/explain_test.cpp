// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/explain.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/auction/bundle.hpp"
#include "core/auction/decision_table.hpp"
#include "sim/replay/counterfactual.hpp"
#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using ::testing::HasSubstr;
using testing::RecordedFleet;
using Kind = Explanation::Kind;

constexpr TimeNs s = 1'000'000'000;

/// A recorded run and its explanations.
class Explained {
 public:
  explicit Explained(PolicyKind policy, const std::function<void(RecordedFleet&)>& live = {},
                     std::uint32_t agents = 4, double loss = 0) {
    Mission mission = testing::random_mission(7, agents, 8);
    mission.auction.policy = policy;
    RecordedFleet fleet(mission, folder_.path(), 7, loss);
    agreed = fleet.run(60 * s);
    if (live) live(fleet);
    winners = fleet.agent({1}).winners();
    fleet.end();
    run.emplace(open_run(folder_.path()));
    playback.emplace(*run);
    explainer.emplace(*run, *playback);
  }
  std::size_t tasks() const { return run->tasks.tasks.size(); }
  const std::vector<Explanation>& story(std::size_t j) const {
    return explainer->explain(TaskId{static_cast<std::uint32_t>(j)});
  }
  std::vector<Explanation> all(Kind kind) const {
    std::vector<Explanation> out;
    for (std::size_t j = 0; j < tasks(); ++j)
      for (const Explanation& told : story(j))
        if (told.kind == kind) out.push_back(told);
    return out;
  }

 private:
  testing::TemporaryFolder folder_;

 public:
  bool agreed = false;
  std::vector<Belief> winners;
  std::optional<RunArchive> run;
  std::optional<Playback> playback;
  std::optional<Explainer> explainer;
};

class EveryPolicy : public ::testing::TestWithParam<PolicyKind> {};
INSTANTIATE_TEST_SUITE_P(Explain, EveryPolicy,
                         ::testing::Values(PolicyKind::claims, PolicyKind::claims_keep,
                                           PolicyKind::cbba, PolicyKind::cbba_rebuild,
                                           PolicyKind::acbba));

TEST_P(EveryPolicy, EndsWithTheOwnersThatTheFleetAgreedOn) {
  const Explained of(GetParam());
  ASSERT_TRUE(of.agreed);
  ASSERT_EQ(of.winners.size(), of.tasks());
  for (std::size_t j = 0; j < of.tasks(); ++j) {
    ASSERT_FALSE(of.story(j).empty()) << j;
    EXPECT_EQ(of.story(j).back().kind, Kind::owner);
    EXPECT_EQ(of.story(j).back().agent, of.winners[j].winner) << j;
    EXPECT_EQ(of.story(j).back().bid, of.winners[j].bid) << j;
  }
}

/// Bids and drops, told in order, lead from nothing to the end.
TEST_P(EveryPolicy, LeavesNoHoldAndNoDropOut) {
  const Explained of(GetParam());
  for (std::size_t j = 0; j < of.tasks(); ++j) {
    std::map<AgentId, double> holders;
    for (const Explanation& told : of.story(j)) {
      if (told.kind == Kind::bid) holders[told.agent] = told.bid;
      if (told.kind != Kind::outbid && told.kind != Kind::released) continue;
      ASSERT_TRUE(holders.contains(told.agent)) << j << ": " << told.text;
      EXPECT_EQ(holders[told.agent], told.bid);
      holders.erase(told.agent);
    }
    ASSERT_EQ(holders.size(), 1u) << j;
    EXPECT_EQ(holders.begin()->first, of.winners[j].winner);
  }
}

TEST_P(EveryPolicy, NamesAMessageThatSaysWhatItIsNamedFor) {
  const Explained of(GetParam());
  const std::vector<Explanation> drops = of.all(Kind::outbid);
  ASSERT_FALSE(drops.empty());
  for (const Explanation& told : drops) {
    ASSERT_TRUE(told.source) << told.text;
    const LifeLog& log = of.run->lives[told.life];
    const auto& marks = log.marks();
    const auto heard = std::find_if(marks.begin(), marks.end(), [&](const Mark& mark) {
      return mark.heard == told.source->id;
    });
    ASSERT_NE(heard, marks.end());
    const auto at = static_cast<std::size_t>(heard - marks.begin());
    EXPECT_LE(at, told.mark);
    const Step step = log.step(at);
    const auto* bid = std::get_if<BidMessage>(&step.event.what);
    ASSERT_TRUE(bid);
    if (const auto* claims = std::get_if<Claims>(&bid->statement.body)) {
      EXPECT_THAT(claims->bundle, ::testing::Contains(Claim{told.task, told.rival.bid}));
      EXPECT_EQ(bid->statement.agent, told.rival.winner);
    } else if (told.rival.winner) {
      EXPECT_EQ(std::get<Table>(bid->statement.body).beliefs[told.task.value], told.rival);
    }
  }
}

TEST(Explain, SaysByWhichRuleABidWins) {
  const Explained of(PolicyKind::claims);
  for (const Explanation& told : of.all(Kind::outbid)) {
    EXPECT_TRUE(beats(told.rival.bid, *told.rival.winner, {told.agent, told.bid})) << told.text;
    EXPECT_THAT(told.text, HasSubstr(told.rival.bid > told.bid ? "eq. (5): higher bid wins"
                                                               : "equal bids: lower id"));
  }
}

TEST(Explain, SaysWhichRowOfTheTableFired) {
  const Explained of(PolicyKind::cbba);
  const std::vector<Explanation> drops = of.all(Kind::outbid);
  ASSERT_FALSE(drops.empty());
  for (const Explanation& told : drops) {
    ASSERT_GE(told.row, 1) << told.text;
    const Row& row = decision_table[static_cast<std::size_t>(told.row - 1)];
    EXPECT_EQ(row.receiver, Who::i) << "it believed to have the task: " << told.text;
    EXPECT_EQ(row.sender == Who::k, told.rival.winner == told.source->id.sender) << told.text;
    EXPECT_THAT(told.text, HasSubstr("Table I, row " + std::to_string(told.row)));
  }
}

TEST(Explain, NamesTheEntryOfTheBundleForWhichAnotherWasReleased) {
  std::size_t lost = 0, freed = 0;
  // With losses agents know different things, and what one gives back another does not take at
  // once.
  for (const std::uint32_t agents : {4u, 6u, 8u}) {
    const Explained of(PolicyKind::claims, {}, agents, 0.4);
    for (const Explanation& told : of.all(Kind::released)) {
      EXPECT_TRUE(told.source) << told.text;
      lost += told.text.find("an earlier entry") != std::string::npos ? 1 : 0;
      freed += told.text.find("could be taken now") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(lost, 0u);
  EXPECT_GT(freed, 0u);
}

TEST(Explain, TellsWhoseDeathMadeATaskFree) {
  const Explained of(PolicyKind::claims, [](RecordedFleet& fleet) {
    fleet.kill({3});
    fleet.run_for(5 * s);
    ASSERT_TRUE(fleet.run(60 * s));
  });
  const std::vector<Explanation> deaths = of.all(Kind::death);
  ASSERT_FALSE(deaths.empty());
  for (const Explanation& told : deaths) EXPECT_EQ(told.rival.winner, AgentId{3});
  for (std::size_t j = 0; j < of.tasks(); ++j) {
    const Explanation* death = decisive_death(of.story(j));
    EXPECT_NE(of.story(j).back().agent, AgentId{3});
    if (death) {
      EXPECT_LT(death->t_ns, of.story(j).back().t_ns);
    }
  }
}

TEST(Explain, GivesAnAgentsStoryInItsOrder) {
  const Explained of(PolicyKind::claims);
  const std::vector<Explanation> story = of.explainer->explain(AgentId{2});
  ASSERT_FALSE(story.empty());
  for (std::size_t n = 0; n < story.size(); ++n) {
    EXPECT_EQ(story[n].agent, AgentId{2});
    if (n > 0) {
      EXPECT_GE(story[n].t_ns, story[n - 1].t_ns);
    }
  }
}

/// Of two agents the other one is the only rival: what it says is all that there is to learn.
TEST(WithoutMessage, KeepsTheTaskUntilTheStatementComesAgain) {
  const Explained of(PolicyKind::claims, {}, 2);
  std::size_t kept = 0;
  for (std::size_t j = 0; j < of.tasks(); ++j) {
    const Explanation* drop = decisive_drop(of.story(j));
    if (!drop) continue;
    const auto other = without_message(*of.run, *drop);
    ASSERT_TRUE(other);
    EXPECT_GE(other->copies, 1u);
    EXPECT_EQ(other->message, drop->source->id);
    if (!other->instead || other->instead_ns <= other->dropped_ns) continue;
    // Nothing that outbids it was heard when it decided.
    ++kept;
    for (const auto& made : other->decisions)
      if (made.t_ns < other->instead_ns) {
        EXPECT_TRUE(made.has_task) << drop->text;
      }
    if (other->dropped_late) {
      EXPECT_GE(*other->dropped_late, other->instead_ns);
    }
  }
  EXPECT_GT(kept, 0u);
}

}  // namespace
}  // namespace arcbid
