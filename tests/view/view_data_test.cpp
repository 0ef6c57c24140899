// SPDX-License-Identifier: GPL-3.0-or-later
// The page is told what the logs say: here it is held against the core itself, step by step.
#include "sim/view/view_data.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/auction/agent.hpp"
#include "core/io/run/run_lock.hpp"
#include "sim/world/world_log.hpp"
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

/// Counts beside the log what became of messages.
class Counting final : public WorldObserver {
 public:
  using Link = std::pair<std::uint32_t, std::uint32_t>;
  explicit Counting(WorldLog& log) : log_(log) {}
  std::map<Link, LinkCounters> links;
  std::map<std::uint32_t, std::uint64_t> said;

  void born(std::uint32_t life, AgentId agent, std::uint64_t incarnation, TimeNs now_ns,
            TimeNs clock_ns) override {
    agents_[life] = agent.value;
    log_.born(life, agent, incarnation, now_ns, clock_ns);
  }
  void stepped(std::uint32_t life, TimeNs now_ns, const Event& event,
               const Update& update) override {
    said[agents_[life]] += update.bids.size() + update.relays.size() + update.statuses.size();
    log_.stepped(life, now_ns, event, update);
  }
  void met_fate(std::uint32_t life, TimeNs now_ns, const Header& header,
                const Fate& fate) override {
    LinkCounters& link = links[{header.sender.value, agents_[life]}];
    link.dropped += fate.arrivals_ns.empty() ? 1 : 0;
    link.delayed += !fate.arrivals_ns.empty() && fate.arrivals_ns.front() > now_ns ? 1 : 0;
    link.duplicated += fate.arrivals_ns.empty() ? 0 : fate.arrivals_ns.size() - 1;
    log_.met_fate(life, now_ns, header, fate);
  }
  void outlived(std::uint32_t life, TimeNs now_ns) override { log_.outlived(life, now_ns); }

 private:
  WorldLog& log_;
  std::map<std::uint32_t, std::uint32_t> agents_;  // by life
};

TEST(ViewData, TellsWhatLinksLostDelayedAndDoubled) {
  const Folder folder;
  WorldSettings settings;
  settings.agents = {4, 4};
  settings.topologies = {TopologyKind::ring};
  for (const WorldFault fault : {WorldFault::loss, WorldFault::delay, WorldFault::duplicate})
    settings.odds[static_cast<std::size_t>(fault)] = 1;
  const WorldSpec world = make_world(settings, 3);
  WorldLog log(world, folder.path / "run");
  Counting counting(log);
  log.write_result(run_world(world, {}, &counting));
  std::map<Counting::Link, LinkCounters> shown;
  const json data = view_data(open_run(folder.path / "run"));
  for (const json& row : data["auction"]["links"]["rows"]) {
    LinkCounters& link = shown[{row[1], row[2]}];
    link.sent += row[3].get<std::uint64_t>();
    link.dropped += row[4].get<std::uint64_t>();
    link.delayed += row[5].get<std::uint64_t>();
    link.duplicated += row[6].get<std::uint64_t>();
  }
  ASSERT_EQ(shown.size(), 12u);
  std::uint64_t delayed = 0, duplicated = 0, silent = 0;
  for (const auto& [link, counts] : shown) {
    const LinkCounters& was = counting.links[link];
    EXPECT_EQ(counts.dropped, was.dropped);
    EXPECT_EQ(counts.delayed, was.delayed);
    EXPECT_EQ(counts.duplicated, was.duplicated);
    EXPECT_LE(counts.sent, counting.said[link.first]) << "a copy is no message of its own";
    EXPECT_GE(counts.sent + 5, counting.said[link.first]) << "a few are under way at the end";
    delayed += counts.delayed;
    duplicated += counts.duplicated;
    silent += counts.dropped == counts.sent ? 1 : 0;
  }
  EXPECT_GT(delayed, 0u);
  EXPECT_GT(duplicated, 0u);
  EXPECT_EQ(silent, 4u) << "those that the ring has not";
}

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
