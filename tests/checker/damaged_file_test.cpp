// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <functional>

#include "tests/checker/valid_run.hpp"

namespace arcbid {
namespace {

struct Damage {
  const char* name;
  std::function<void(const RunFolder&)> by;
  const char* verdicts;
  const char* reason;
};

void replace_in(const RunFolder& folder, const std::string& file, const std::string& from,
                const std::string& to) {
  std::string text = folder.read_text(file);
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  folder.write_text(file, text.replace(at, from.size(), to));
}

constexpr const char* kRoute2 = "routes/agent_2.json";

const Damage kDamage[] = {
    {"no_folder", [](auto& f) { std::filesystem::remove_all(f.path()); }, "----",
     "arcs.json: the file is missing"},
    {"no_arcs", [](auto& f) { std::filesystem::remove(f.path() / "arcs.json"); }, "----",
     "arcs.json: the file is missing"},
    {"arcs_a_folder",
     [](auto& f) {
       std::filesystem::remove(f.path() / "arcs.json");
       std::filesystem::create_directory(f.path() / "arcs.json");
     },
     "----", "arcs.json: not a regular file"},
    {"arcs_empty", [](auto& f) { f.write_text("arcs.json", ""); }, "----", "arcs.json: not JSON"},
    {"arcs_an_array", [](auto& f) { f.write_text("arcs.json", "[]"); }, "----",
     "arcs.json: the document is an array, must be an object"},
    {"arcs_of_another_schema",
     [](auto& f) { replace_in(f, "arcs.json", R"("schema":1)", R"("schema":2)"); }, "----",
     "arcs.json: schema is 2, must be 1"},
    {"arc_of_wrong_length",
     [](auto& f) { replace_in(f, "arcs.json", R"("length_m":20.0)", R"("length_m":20.01)"); },
     "----", "arcs.json: arcs[0].length_m is 20.01, must be 20.0000"},
    {"arc_published_twice", [](auto& f) { replace_in(f, "arcs.json", R"("arc":1)", R"("arc":0)"); },
     "----", "arcs.json: arcs[1].arc is 0, must be an id of its own"},
    {"speed_zero",
     [](auto& f) { replace_in(f, "arcs.json", R"("speed_mps":2.0)", R"("speed_mps":0)"); }, "----",
     "arcs.json: fleet[0].speed_mps is 0, must be above 0"},
    {"no_routes", [](auto& f) { std::filesystem::remove_all(f.path() / "routes"); }, "----",
     "complete: no agent delivered a readable route"},
    {"one_route_missing", [](auto& f) { std::filesystem::remove(f.path() / kRoute2); }, "C--R",
     "is owned by agent 2, which delivered no route"},
    {"route_truncated",
     [](auto& f) {
       const std::string text = f.read_text(kRoute2);
       f.write_text(kRoute2, text.substr(0, text.size() / 2));
     },
     "C---", "routes_valid: routes/agent_2.json: not JSON"},
    {"not_a_number_word",
     [](auto& f) { replace_in(f, kRoute2, R"("from_m":20.0)", R"("from_m":NaN)"); }, "C---",
     "routes_valid: routes/agent_2.json: not JSON"},
    {"not_a_number_as_null",
     [](auto& f) { replace_in(f, kRoute2, R"("from_m":20.0)", R"("from_m":null)"); }, "C---",
     "routes/agent_2.json: route.legs[3].from_m is null, must be a finite number"},
    {"number_too_large",
     [](auto& f) { replace_in(f, kRoute2, R"("from_m":20.0)", R"("from_m":1e999)"); }, "C---",
     "routes/agent_2.json: not JSON"},
    {"huge_but_finite", [](auto& f) { replace_in(f, kRoute2, "[12,10,10,", "[1e308,-1e308,10,"); },
     "CcA-", "agent 2"},
    {"text_for_number",
     [](auto& f) { replace_in(f, kRoute2, R"("from_m":20.0)", R"("from_m":"20")"); }, "C---",
     R"(route.legs[3].from_m is "20", must be a finite number)"},
    {"negative_owner", [](auto& f) { replace_in(f, kRoute2, R"("owner":2)", R"("owner":-2)"); },
     "C---", "agreement.tasks[2].owner is -2, must be an integer from 0 to 4294967295"},
    {"field_missing", [](auto& f) { replace_in(f, kRoute2, "view_hash", "view"); }, "C---",
     "agreement.view_hash is missing"},
    {"unknown_kind_of_leg",
     [](auto& f) { replace_in(f, kRoute2, R"("kind":"transit")", R"("kind":"hover")"); }, "C---",
     R"(route.legs[0].kind is "hover", must be "arc" or "transit")"},
    {"lone_waypoint", [](auto& f) { replace_in(f, kRoute2, ",[12,10,10,0,0,-1]", ""); }, "C---",
     "route.legs[1].waypoints is an array, must be at least two waypoints"},
    {"named_after_another_agent",
     [](auto& f) { f.write_text("routes/agent_3.json", f.read_text(kRoute2)); }, "CcA-",
     "routes/agent_3.json: agent is 2, must be the id in the file's name"},
    {"bytes_that_are_no_text",
     [](auto& f) { replace_in(f, kRoute2, R"("kind":"transit")", "\"kind\":\"\xff\xfe\""); },
     "C---", "routes/agent_2.json: not JSON"},
    {"deeply_nested", [](auto& f) { f.write_text(kRoute2, std::string(200'000, '[')); }, "C---",
     "routes/agent_2.json: not JSON"},
};

class DamagedRun : public testing::TestWithParam<Damage> {};

TEST_P(DamagedRun, IsAProblemInTheReport) {
  const RunFolder folder;
  folder.write(valid_run());
  GetParam().by(folder);
  const CheckReport report = check_run(folder.path());
  EXPECT_EQ(verdicts(report), GetParam().verdicts) << listed(report);
  EXPECT_THAT(listed(report), testing::HasSubstr(GetParam().reason));
  EXPECT_NO_THROW(nlohmann::json::parse(to_json(report)));
}

INSTANTIATE_TEST_SUITE_P(Each, DamagedRun, testing::ValuesIn(kDamage),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DamagedRuns, EveryTruncationOfARouteIsReported) {
  const RunFolder folder;
  folder.write(valid_run());
  const std::string text = folder.read_text(kRoute2);
  for (std::size_t size = 0; size < text.size(); size += 13) {
    folder.write_text(kRoute2, text.substr(0, size));
    ASSERT_EQ(verdicts(check_run(folder.path())), "C---") << size;
  }
}

}  // namespace
}  // namespace arcbid
