// SPDX-License-Identifier: GPL-3.0-or-later
// Work left undone: a reason that holds is accepted, and is not success; one that does not hold,
// and work dropped without a word, are found.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "tests/checker/valid_run.hpp"

namespace arcbid {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Arc 1, task 3, is nobody's: agent 1 flies all of arc 0 and carries no camera; agent 2 stays at
/// home, for it lasts 34 s and arc 1 alone takes 10 m up to it, 10 m along and sqrt(200) m home.
RunDocuments run_without_arc_1() {
  RunDocuments run = valid_run();
  run.arcs["transits"] = "straight";
  run.arcs["fleet"][0]["endurance_s"] = 23.5;
  run.arcs["fleet"][0]["payload"] = "lidar";
  run.arcs["fleet"][1]["endurance_s"] = 34;
  run.arcs["fleet"][1]["payload"] = "any";
  run.arcs["arcs"][1]["payload"] = "camera";
  const double length_m = std::sqrt(125.0) + 20 + 15;
  run.agent_1["route"] = {
      {"length_m", length_m}, {"time_s", length_m / 2}, {"legs", json::parse(R"([
    {"kind": "transit", "waypoints": [[10, 5, 0, 1, 0, 0], [10, 10, 10, 1, 0, 0]]},
    {"kind": "arc", "arc": 0, "from_m": 20.0, "to_m": 0.0, "waypoints": [
      [10, 10, 10, 1, 0, 0], [10, 0, 10, 0.6, 0.8, 0], [0, 0, 10, 0, 1, 0]]},
    {"kind": "transit", "waypoints": [[0, 0, 10, 0, 1, 0], [10, 5, 0, 0, 1, 0]]}])")}};
  run.agent_2["route"] = {{"length_m", 0}, {"time_s", 0}, {"legs", json::array()}};
  for (json* agent : {&run.agent_1, &run.agent_2}) {
    (*agent)["agreement"]["tasks"][2]["owner"] = 1;
    (*agent)["agreement"]["tasks"][3]["owner"] = nullptr;
    (*agent)["agreement"]["no_bidders"] = json::parse(R"([
      {"arc": 1, "from_m": 0, "to_m": 10, "why": "endurance", "needs": "camera", "agent": 2,
       "needed_s": 34.142135623730951, "endurance_s": 34, "limit": 0, "text": "arc 1: no bidder"}])");
  }
  return run;
}

CheckReport checked(const RunDocuments& run) {
  const RunFolder folder;
  folder.write(run);
  return check_run(folder.path());
}

CheckReport checked(const std::function<void(json& left)>& change) {
  RunDocuments run = run_without_arc_1();
  for (json* agent : {&run.agent_1, &run.agent_2}) change((*agent)["agreement"]["no_bidders"][0]);
  return checked(run);
}

TEST(LeftUndone, WithAReasonThatHoldsIsNotWrongAndNotSuccess) {
  const CheckReport report = checked(run_without_arc_1());
  EXPECT_EQ(verdicts(report), "CcAR") << listed(report);
  EXPECT_TRUE(report.ok());
  EXPECT_FALSE(report.all_done());
  ASSERT_EQ(report.left.size(), 1u);
  EXPECT_EQ(report.left[0].arc, 1u);
  EXPECT_EQ(report.left[0].text, "arc 1: no bidder");
  EXPECT_DOUBLE_EQ(report.left_m(), 10);
  EXPECT_TRUE(json::parse(to_json(report))["all_done"] == false);
  EXPECT_EQ(json::parse(to_json(report))["no_bidders"][0]["why"], "endurance");
}

TEST(LeftUndone, WithoutAReasonIsFound) {
  RunDocuments run = run_without_arc_1();
  for (json* agent : {&run.agent_1, &run.agent_2}) (*agent)["agreement"].erase("no_bidders");
  const CheckReport report = checked(run);
  EXPECT_EQ(verdicts(report), "C--R");
  EXPECT_THAT(listed(report), HasSubstr("has no owner, and no reason is given"));
  EXPECT_THAT(listed(report), HasSubstr("arc 1 (10.0000 m): 10.0000 m not covered"));
}

TEST(LeftUndone, IsTheSameForAllWhoAgreed) {
  RunDocuments run = run_without_arc_1();
  run.agent_2["agreement"]["no_bidders"][0]["needed_s"] = 35;
  EXPECT_EQ(verdicts(checked(run)), "-cAR");
}

TEST(LeftUndone, DoesNotHideAPieceBesideIt) {
  const CheckReport report = checked([](json& left) { left["to_m"] = 9; });
  EXPECT_EQ(verdicts(report), "C--R");
  EXPECT_THAT(listed(report), HasSubstr("1.0000 m not covered"));
}

TEST(LeftUndone, IsNobodys) {
  RunDocuments run = run_without_arc_1();
  for (json* agent : {&run.agent_1, &run.agent_2}) (*agent)["agreement"]["tasks"][3]["owner"] = 2;
  EXPECT_THAT(listed(checked(run)), HasSubstr("task 3 of it is agent 2's"));
}

struct False {
  const char* name;
  std::function<void(json& left)> by;
  const char* found;
};
void PrintTo(const False& one, std::ostream* out) {
  *out << one.name;
}
class FalseReason : public testing::TestWithParam<False> {};

TEST_P(FalseReason, IsFound) {
  const CheckReport report = checked(GetParam().by);
  EXPECT_FALSE(report.complete);
  EXPECT_THAT(listed(report), HasSubstr(GetParam().found));
}

INSTANTIATE_TEST_SUITE_P(
    , FalseReason,
    testing::Values(
        False{"needs_less_than_its_endurance", [](json& l) { l["needed_s"] = 33; },
              "are not more than 34"},
        False{"needs_less_than_straight_there", [](json& l) { l["needed_s"] = 34.1; },
              "34.1421, are not more than 34"},
        False{"another_endurance", [](json& l) { l["endurance_s"] = 33; },
              "agent 2 has no endurance of 33 s"},
        False{"payload_that_somebody_carries",
              [](json& l) {
                l["why"] = "payload";
                l["agent"] = nullptr;
              },
              "agent 2 carries any"},
        False{"another_payload", [](json& l) { l["needs"] = "lidar"; }, "it needs camera"},
        False{"limit_that_is_not_reached",
              [](json& l) {
                l["why"] = "bundle-limit";
                l["agent"] = nullptr;
                l["limit"] = 0;
              },
              "agent 2 won 0 tasks, the limit is 0"},
        False{"no_reason_at_all", [](json& l) { l["why"] = "weather"; }, "'weather' is no reason"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(LeftUndone, IsRefutedByWhoCouldFlyItAlone) {
  RunDocuments run = run_without_arc_1();
  run.arcs["fleet"][0]["payload"] = "camera";  // at 2 m/s it takes 18.9 s of 23.5
  EXPECT_THAT(listed(checked(run)), HasSubstr("agent 1 could fly it alone in"));
  run.arcs["transits"] = "around obstacles";
  EXPECT_EQ(verdicts(checked(run)), "CcAR") << "ways around may be longer";
  run.arcs["fleet"][0]["endurance_s"] = nullptr;
  EXPECT_THAT(listed(checked(run)), HasSubstr("agent 1 has no limit to its endurance"));
}

/// Exchanges may leave somebody with fewer tasks than it won: room came too late.
TEST(LeftUndone, GoesByWhatWasWonNotByWhatIsFlown) {
  RunDocuments run = run_without_arc_1();
  run.arcs["fleet"][1]["endurance_s"] = nullptr;
  for (json* agent : {&run.agent_1, &run.agent_2}) {
    json& left = (*agent)["agreement"]["no_bidders"][0];
    left["why"] = "bundle-limit";
    left["agent"] = nullptr;
    left["limit"] = 3;
    for (json& task : (*agent)["agreement"]["tasks"])
      if (task["owner"] == 1) task["won_by"] = 2;
  }
  EXPECT_EQ(verdicts(checked(run)), "CcAR") << listed(checked(run));
  for (json* agent : {&run.agent_1, &run.agent_2})
    for (json& task : (*agent)["agreement"]["tasks"]) task.erase("won_by");
  EXPECT_THAT(listed(checked(run)), HasSubstr("agent 2 won 0 tasks and may take 3"));
}

TEST(LeftUndone, OfABundleLimitIsRefutedByWhoHasRoomAndCouldFlyItAlone) {
  const auto by_limit = [](json& left) {
    left["why"] = "bundle-limit";
    left["agent"] = nullptr;
    left["limit"] = 1;
  };
  RunDocuments run = run_without_arc_1();
  for (json* agent : {&run.agent_1, &run.agent_2}) by_limit((*agent)["agreement"]["no_bidders"][0]);
  EXPECT_EQ(verdicts(checked(run)), "CcAR") << "agent 2 does not last: " << listed(checked(run));
  run.arcs["fleet"][1]["endurance_s"] = 35;
  EXPECT_THAT(listed(checked(run)), HasSubstr("agent 2 could fly it alone in 34.1421 s of 35"));
}

TEST(Limits, OfARouteAreItsUavs) {
  RunDocuments run = valid_run();
  run.arcs["fleet"][1]["endurance_s"] = 43.5;
  EXPECT_TRUE(checked(run).all_done()) << listed(checked(run));
  run.arcs["fleet"][1]["endurance_s"] = 43.4;
  EXPECT_EQ(verdicts(checked(run)), "CcA-");
  EXPECT_THAT(listed(checked(run)), HasSubstr("its route takes 43.4012 s, its endurance is 43.4"));
  run = valid_run();
  run.arcs["fleet"][1]["payload"] = "lidar";
  run.arcs["arcs"][1]["payload"] = "camera";
  EXPECT_EQ(verdicts(checked(run)), "CcA-");
  EXPECT_THAT(listed(checked(run)), HasSubstr("arc 1 needs a camera, it carries a lidar"));
}

}  // namespace
}  // namespace arcbid
