// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/misfit.hpp"

#include <gtest/gtest.h>

namespace arcbid {
namespace {

constexpr std::size_t tasks = 3;

Mission two_agents() {
  Mission mission;
  mission.fleet.resize(2);
  mission.fleet[0].id = {4};
  mission.fleet[1].id = {9};
  return mission;
}

Step heard(Statement statement) {
  BidMessage bid;
  bid.header.sender = statement.agent;
  bid.statement = std::move(statement);
  return {{1, bid}, {}};
}

TEST(Misfit, LetsPassWhatIsOfTheMission) {
  EXPECT_EQ(misfit(heard({{4}, {1, false, 1}, Claims{{{{2}, -1}}}}), two_agents(), tasks),
            std::nullopt);
  const Table table{{{AgentId{9}, 1}, {}, {}}, {1, 2}};
  EXPECT_EQ(misfit(heard({{9}, {1, false, 1}, table}), two_agents(), tasks), std::nullopt);
}

TEST(Misfit, NamesTheTaskOrTheAgentThatIsNot) {
  EXPECT_EQ(misfit(heard({{4}, {1, false, 1}, Claims{{{{3}, -1}}}}), two_agents(), tasks),
            "task 3 is not of its mission");
  EXPECT_EQ(misfit(heard({{5}, {1, false, 1}, Claims{}}), two_agents(), tasks),
            "agent 5 is not of its mission");
  Step step;
  step.update.decision = DecisionMade{1, true, {}, Claims{}, {{{7}, false}}};
  EXPECT_EQ(misfit(step, two_agents(), tasks), "task 7 is not of its mission");
  step.update.decision.reset();
  step.update.died = {{6}};
  EXPECT_EQ(misfit(step, two_agents(), tasks), "agent 6 is not of its mission");
}

TEST(Misfit, NamesATableOfAnotherSizeAndAWinnerOfNoFleet) {
  EXPECT_EQ(misfit(heard({{4}, {1, false, 1}, Table{{{}, {}}, {1, 2}}}), two_agents(), tasks),
            "a table of size 2 is not of its mission");
  EXPECT_EQ(misfit(heard({{4}, {1, false, 1}, Table{{{}, {}, {AgentId{8}, 1}}, {1, 2}}}),
                   two_agents(), tasks),
            "agent 8 is not of its mission");
}

TEST(Misfit, LetsAnythingPassThatTheCoreRefused) {
  Step step = heard({{5}, {1, false, 1}, Claims{{{{300}, -1}}}});
  step.update.refused = "agent 5 is not of the fleet";
  EXPECT_EQ(misfit(step, two_agents(), tasks), std::nullopt);
}

}  // namespace
}  // namespace arcbid
