// SPDX-License-Identifier: GPL-3.0-or-later
// One thing broken at a time: just the verdicts that it concerns fail, and the reason names it.
#include <gmock/gmock.h>

#include <functional>

#include "tests/checker/valid_run.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

struct Broken {
  const char* name;
  std::function<void(RunDocuments&)> by;
  const char* verdicts;  ///< what remains of "CcAR"
  const char* reason;    ///< part of the problems listed
};

json& task(json& agent, int k) {
  return agent["agreement"]["tasks"][k];
}
json& leg(json& agent, int k) {
  return agent["route"]["legs"][k];
}
json& waypoint(json& agent, int k, int i) {
  return leg(agent, k)["waypoints"][i];
}
void for_both(RunDocuments& run, const std::function<void(json&)>& change) {
  change(run.agent_1);
  change(run.agent_2);
}

const Broken kBroken[] = {
    // conflict_free
    {"swapped_owner_in_one_table", [](auto& r) { task(r.agent_1, 3)["owner"] = 1; }, "-cA-",
     "agent 1 holds task 3"},
    {"other_bid_in_one_table", [](auto& r) { task(r.agent_2, 0)["bid"] = -40.50000000000001; },
     "-cAR", "bid -40.50000000000001"},
    {"other_view", [](auto& r) { r.agent_2["agreement"]["view_hash"] = "beef"; }, "-cAR",
     "agents 1 and 2 agreed under different views: cafe and beef"},
    {"task_with_two_owners",
     [](auto& r) {
       for_both(r, [](json& a) {
         json again = task(a, 3);
         again["owner"] = 1;
         a["agreement"]["tasks"].push_back(again);
       });
     },
     "-c--", "task 3 is in its table twice, for agent 2 and agent 1"},
    {"task_unknown_to_one", [](auto& r) { r.agent_2["agreement"]["tasks"].erase(0); }, "-c-R",
     "agent 1 knows 4 tasks, agent 2 knows 3"},
    // complete
    {"task_without_owner",
     [](auto& r) { for_both(r, [](json& a) { task(a, 3)["owner"] = nullptr; }); }, "C-A-",
     "task 3 (arc 1 0 to 10 m) has no owner"},
    {"task_of_an_agent_without_route",
     [](auto& r) { for_both(r, [](json& a) { task(a, 3)["owner"] = 7; }); }, "C-A-",
     "task 3 (arc 1 0 to 10 m) is owned by agent 7, which delivered no route"},
    // arcs_conserved
    {"overlapping_tasks",
     [](auto& r) { for_both(r, [](json& a) { task(a, 1)["from_m"] = 7.498; }); }, "Cc-R",
     "arc 0 (20.0000 m): 0.0020 m covered twice"},
    {"gap_between_tasks",
     [](auto& r) { for_both(r, [](json& a) { task(a, 1)["to_m"] = 14.998; }); }, "Cc--",
     "arc 0 (20.0000 m): 0.0020 m not covered"},
    {"gaps_that_add_up",
     [](auto& r) {
       for_both(r, [](json& a) {
         task(a, 0)["to_m"] = 7.4994;
         task(a, 1)["to_m"] = 14.9994;
       });
     },
     "Cc--", "0.0012 m not covered"},
    {"task_of_an_unknown_arc", [](auto& r) { for_both(r, [](json& a) { task(a, 3)["arc"] = 9; }); },
     "Cc--", "arc 9 of task 3 was never published"},
    {"arc_that_nobody_has",
     [](auto& r) {
       json arc = r.arcs["arcs"][1];
       arc["arc"] = 2;
       r.arcs["arcs"].push_back(arc);
     },
     "Cc-R", "arc 2 (10.0000 m): 10.0000 m not covered"},
    {"leg_flown_twice",
     [](auto& r) {  // there, back through transit, and again; sums adjusted
       auto& legs = r.agent_2["route"]["legs"];
       const json again = legs[1];
       const json back = {{"kind", "transit"},
                          {"waypoints", {again["waypoints"][1], again["waypoints"][0]}}};
       legs.insert(legs.begin() + 2, {back, again});
       for (const char* sum : {"length_m", "time_s"}) r.agent_2["route"][sum] = 63.401219466856727;
     },
     "Cc-R",
     "arc 1 (10.0000 m): 10.0000 m covered twice, the longest part from 0.0000 to 10.0000 m "
     "by agent 2 and agent 2"},
    // routes_valid
    {"leg_dropped", [](auto& r) { r.agent_2["route"]["legs"].erase(1); }, "Cc--",
     "agent 2: what it won of arc 1 and what it flies differ by 10.0000 m"},
    {"transit_dropped", [](auto& r) { r.agent_2["route"]["legs"].erase(2); }, "CcA-",
     "agent 2: a jump of 2.0000 m"},
    {"waypoint_shifted_by_2_mm", [](auto& r) { waypoint(r.agent_1, 1, 1)[2] = 10.002; }, "CcA-",
     "agent 1 leg 1 (arc 0 15 to 0 m): waypoint 1"},
    {"corner_cut", [](auto& r) { leg(r.agent_1, 1)["waypoints"].erase(1); }, "CcA-",
     "agent 1 leg 1 (arc 0 15 to 0 m): waypoint 1 at (0.000, 0.000, 10.000)"},
    {"leg_cut_short", [](auto& r) { waypoint(r.agent_1, 1, 2)[0] = 0.002; }, "CcA-",
     "it does not reach (0.000, 0.000, 10.000)"},
    {"wrong_way_round",
     [](auto& r) { std::swap(leg(r.agent_2, 1)["from_m"], leg(r.agent_2, 1)["to_m"]); }, "CcA-",
     "agent 2 leg 1 (arc 1 10 to 0 m): it begins at (22.000, 10.000, 10.000)"},
    {"looks_away", [](auto& r) { waypoint(r.agent_1, 1, 1)[4] = -0.8; }, "CcA-",
     "waypoint 1 looks along (0.600, -0.800, 0.000)"},
    {"look_not_a_unit_vector", [](auto& r) { waypoint(r.agent_1, 0, 1)[3] = 1.001; }, "CcA-",
     "agent 1 leg 0: the look (1.001, 0.000, 0.000) of waypoint 1 is not a unit vector"},
    {"leg_of_an_unknown_arc", [](auto& r) { leg(r.agent_2, 1)["arc"] = 9; }, "Cc--",
     "agent 2 leg 1 (arc 9 0 to 10 m): was never published"},
    {"leg_beyond_the_arc", [](auto& r) { leg(r.agent_2, 1)["to_m"] = 10.5; }, "Cc--",
     "agent 2 leg 1 (arc 1 0 to 10.5 m): is only 10.0000 m long"},
    {"wrong_length", [](auto& r) { r.agent_1["route"]["length_m"] = 40.002; }, "CcA-",
     "agent 1: length_m is 40.0020, its waypoints add up to 40.0000"},
    {"wrong_time", [](auto& r) { r.agent_1["route"]["time_s"] = 40.0; }, "CcA-",
     "agent 1: time_s is 40.0000"},
    {"wrong_home", [](auto& r) { r.arcs["fleet"][0]["home_m"][1] = 5.01; }, "CcA-",
     "agent 1: a jump of 0.0100 m from home"},
    {"detour_that_is_not_counted",
     [](auto& r) {
       auto& waypoints = leg(r.agent_1, 0)["waypoints"];
       waypoints.insert(waypoints.begin() + 1, json({0, 5, 0, 1, 0, 0}));
     },
     "CcA-", "agent 1: length_m is 40.0000"},
    {"not_in_the_fleet", [](auto& r) { r.arcs["fleet"].erase(1); }, "CcA-",
     "agent 2 is not in the fleet"},
    {"route_of_another_mission", [](auto& r) { r.agent_2["mission"] = "0ld"; }, "CcA-",
     "agent 2: its route is for mission 0ld"},
    {"bogus_pieces_that_swap_agents",
     [](auto& r) {
       for_both(r, [](json& a) {
         task(a, 1)["owner"] = 2;
         task(a, 2)["owner"] = 1;
       });
     },
     "CcA-", "agent 2: what it won of arc 0 and what it flies differ by 12.5000 m"},
};

class BrokenRun : public testing::TestWithParam<Broken> {};

TEST_P(BrokenRun, FailsJustTheVerdictsItConcerns) {
  RunDocuments run = valid_run();
  GetParam().by(run);
  const RunFolder folder;
  folder.write(run);
  const CheckReport report = check_run(folder.path());
  EXPECT_EQ(verdicts(report), GetParam().verdicts) << listed(report);
  EXPECT_THAT(listed(report), testing::HasSubstr(GetParam().reason));
}

INSTANTIATE_TEST_SUITE_P(Each, BrokenRun, testing::ValuesIn(kBroken),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BrokenRuns, ManyProblemsAreCounted) {
  RunDocuments run = valid_run();
  auto& waypoints = leg(run.agent_1, 0)["waypoints"];
  for (int k = 0; k < 40; ++k) waypoints.insert(waypoints.begin(), json({10, 5, 0, 2, 0, 0}));
  const RunFolder folder;
  folder.write(run);
  const CheckReport report = check_run(folder.path());
  EXPECT_EQ(verdicts(report), "CcA-");
  EXPECT_EQ(report.problems.size(), 11U);
  EXPECT_EQ(report.problems.back(), "routes_valid: and 30 more");
}

}  // namespace
}  // namespace arcbid
