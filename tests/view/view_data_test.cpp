// SPDX-License-Identifier: GPL-3.0-or-later
// The page is told what the logs say: here it is held against the core itself, step by step.
#include "sim/view/view_data.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/auction/agent.hpp"
#include "core/io/run/run_lock.hpp"
#include "tests/view/recorded_world.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;

class ViewDataTest : public ::testing::TestWithParam<PolicyKind> {
 protected:
  ViewDataTest() {
    record_world(GetParam(), 3, folder.path / "run");
    run = open_run(folder.path / "run");
    data = view_data(run);
  }
  Folder folder;
  RunArchive run;
  json data;
};

/// z and y from the page's changes, as they stand at a time.
struct Believed {
  std::vector<Belief> z;
  std::size_t next = 0;

  void until(const json& changes, double t_s) {
    for (; next < changes.size() && changes[next]["t_s"] <= t_s; ++next) {
      const json& c = changes[next]["z"];
      for (std::size_t n = 0; n < c.size(); n += 3) {
        const bool nobody = c[n + 1] == -1;
        z[c[n].get<std::size_t>()] =
            nobody ? Belief{}
                   : Belief{AgentId{c[n + 1].get<std::uint32_t>()}, c[n + 2].get<double>()};
      }
    }
  }
};

TEST_P(ViewDataTest, SaysWhatEveryAgentBelievedAtAnyTime) {
  std::size_t compared = 0;
  for (const json& view : data["auction"]["views"]) {
    Believed page{std::vector<Belief>(run.tasks.tasks.size()), 0};
    for (const LifeLog& life : run.lives) {
      if (life.agent().value != view["agent"]) continue;
      Agent core(life.agent(), life.birth()->incarnation, life.mission(),
                 std::make_shared<const StraightTransit>(), life.birth()->now_ns);
      const auto& marks = life.marks();
      life.steps([&](std::size_t mark, const Step& step, std::string_view) {
        core.step(step.event);
        if (mark + 1 < marks.size() && marks[mark + 1].t_ns == marks[mark].t_ns) return true;
        page.until(view["changes"], seconds(marks[mark].t_ns));
        const auto winners = core.winners();
        for (std::size_t j = 0; j < winners.size(); ++j)
          EXPECT_TRUE(page.z[j] == winners[j] || !(winners[j].winner || page.z[j].winner))
              << "agent " << view["agent"] << ", task " << j;
        ++compared;
        return !HasFailure();
      });
    }
  }
  EXPECT_GT(compared, 100u);
}

TEST_P(ViewDataTest, TellsDeathsReturnsAndTheAgreement) {
  std::set<std::string> kinds;
  for (const json& event : data["auction"]["events"]) kinds.insert(event["kind"]);
  for (const char* kind : {"start", "death", "return", "conflict", "agreement", "route"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

TEST_P(ViewDataTest, EndsWithOwnersThatAreOneAnothersDecisions) {
  std::map<std::uint32_t, json> last;
  for (const json& decision : data["auction"]["decisions"])
    last[decision["agent"]] = decision["bundle"];
  std::set<std::uint32_t> owned;
  for (const auto& [agent, bundle] : last)
    for (std::size_t n = 0; n < bundle.size(); n += 2)
      EXPECT_TRUE(owned.insert(bundle[n].get<std::uint32_t>()).second) << "claimed twice";
  EXPECT_EQ(owned.size(), run.tasks.tasks.size());
}

TEST_P(ViewDataTest, CountsEveryMessageOnItsLink) {
  std::size_t heard = 0, sent = 0, lost = 0;
  for (const LifeLog& life : run.lives)
    for (const Mark& mark : life.marks()) heard += mark.heard ? 1 : 0;
  for (const json& row : data["auction"]["links"]["rows"]) {
    EXPECT_NE(row[1], row[2]);
    sent += row[3].get<std::size_t>();
    lost += row[4].get<std::size_t>();
  }
  EXPECT_GT(heard, 0u);
  EXPECT_GT(lost, 0u);
  EXPECT_EQ(sent, heard + lost);
}

TEST_P(ViewDataTest, HasARouteForEveryAgentAtItsPace) {
  const json& routes = data["mission"]["routes"];
  ASSERT_EQ(routes.size(), 5u);
  for (const json& route : routes) {
    const auto vertices = route["line"].size() / 3;
    ASSERT_EQ(route["at_s"].size(), vertices);
    ASSERT_EQ(route["arc"].size(), vertices == 0 ? 0 : vertices - 1);
    ASSERT_GT(vertices, 0u);
    EXPECT_NEAR(route["at_s"].back(), route["time_s"], 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Under, ViewDataTest,
                         ::testing::Values(PolicyKind::claims, PolicyKind::claims_keep,
                                           PolicyKind::cbba_rebuild));

TEST(ViewData, IsLiveWhileTheLauncherRuns) {
  const Folder folder;
  const auto run = folder.path / "run";
  record_world(PolicyKind::claims, 3, run);
  EXPECT_FALSE(view_data(open_run(run))["live"]);
  const auto count = [&run](const char* state) {
    const json data = view_data(open_run(run));
    std::size_t found = 0;
    for (const json& one : data["auction"]["states"]) found += one["state"] == state ? 1 : 0;
    return found;
  };
  EXPECT_EQ(count("ended"), 5u) << "they outlived the world";
  EXPECT_EQ(count("dead"), 1u) << "the one that came back had died";
  std::filesystem::remove(run / "result.json");
  EXPECT_FALSE(view_data(open_run(run))["live"]) << "nobody writes it any more";
  EXPECT_EQ(count("dead"), 1u);
  const RunLock launcher(run);
  EXPECT_TRUE(view_data(open_run(run))["live"]);
  EXPECT_EQ(count("dead"), 0u) << "it may yet be heard of";
}

}  // namespace
}  // namespace arcbid::testing
