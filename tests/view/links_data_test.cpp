// SPDX-License-Identifier: GPL-3.0-or-later
// What the page is told of links, held against the world that did it to them.
#include <gmock/gmock.h>

#include <set>

#include "sim/view/view_data.hpp"
#include "sim/world/world_log.hpp"
#include "tests/view/recorded_world.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;

/// Counts beside the log what became of messages.
class Counting final : public WorldObserver {
 public:
  using Link = std::pair<std::uint32_t, std::uint32_t>;
  using Number = std::pair<std::uint64_t, std::uint64_t>;  // incarnation, sequence
  explicit Counting(WorldLog& log) : log_(log) {}
  std::map<Link, LinkCounters> links;
  std::map<Link, std::map<Number, std::uint32_t>> came;  // every message once, to which life
  std::size_t heard_by_the_next_life = 0;
  std::map<std::uint32_t, std::uint64_t> said;

  void born(std::uint32_t life, AgentId agent, std::uint64_t incarnation, TimeNs now_ns,
            TimeNs clock_ns) override {
    agents_[life] = agent.value;
    log_.born(life, agent, incarnation, now_ns, clock_ns);
  }
  void stepped(std::uint32_t life, TimeNs now_ns, const Event& event,
               const Update& update) override {
    said[agents_[life]] += update.bids.size() + update.relays.size() + update.statuses.size();
    std::visit(
        [&](const auto& what) {
          if constexpr (requires { what.header; }) note(life, what.header);
        },
        event.what);
    log_.stepped(life, now_ns, event, update);
  }
  void met_fate(std::uint32_t life, TimeNs now_ns, const Header& header,
                const Fate& fate) override {
    LinkCounters& link = links[{header.sender.value, agents_[life]}];
    note(life, header);
    link.dropped += fate.arrivals_ns.empty() ? 1 : 0;
    link.delayed += !fate.arrivals_ns.empty() && fate.arrivals_ns.front() > now_ns ? 1 : 0;
    link.duplicated += fate.arrivals_ns.empty() ? 0 : fate.arrivals_ns.size() - 1;
    log_.met_fate(life, now_ns, header, fate);
  }
  void outlived(std::uint32_t life, TimeNs now_ns) override { log_.outlived(life, now_ns); }

 private:
  void note(std::uint32_t life, const Header& header) {
    const Number number{header.incarnation, header.sequence};
    const auto at = came[{header.sender.value, agents_[life]}].emplace(number, life).first;
    if (at->second != life) ++heard_by_the_next_life;
  }
  WorldLog& log_;
  std::map<std::uint32_t, std::uint32_t> agents_;  // by life
};

std::map<Counting::Link, LinkCounters> shown_of(const std::filesystem::path& run) {
  std::map<Counting::Link, LinkCounters> shown;
  const json data = view_data(open_run(run));
  for (const json& row : data["auction"]["links"]["rows"]) {
    LinkCounters& link = shown[{row[1], row[2]}];
    link.sent += row[3].get<std::uint64_t>();
    link.dropped += row[4].get<std::uint64_t>();
    link.delayed += row[5].get<std::uint64_t>();
    link.duplicated += row[6].get<std::uint64_t>();
  }
  return shown;
}

TEST(LinksData, TellsWhatLinksLostDelayedAndDoubled) {
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
  const auto shown = shown_of(folder.path / "run");
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

/// A message that came to one life may be heard by the next.
TEST(LinksData, CountsAMessageOnceOverAllLivesOfItsReceiver) {
  constexpr TimeNs ms = 1'000'000;
  const Folder folder;
  WorldSettings settings;
  settings.agents = {4, 4};
  settings.topologies = {TopologyKind::complete};
  WorldSpec world = make_world(settings, 3);
  LinkFault link;
  link.delay = Delay{Delay::Kind::uniform, 60 * ms, 120 * ms, 0};
  link.duplicate = 0.3;
  world.faults.links = {link};
  AgentFault away;
  away.agent = {2};
  away.at_ns = 300 * ms;
  away.for_ns = 30 * ms;
  world.faults.agents = {away};
  WorldLog log(world, folder.path / "run");
  Counting counting(log);
  log.write_result(run_world(world, {}, &counting));
  ASSERT_GT(counting.heard_by_the_next_life, 0u);
  for (const auto& [from_to, counts] : shown_of(folder.path / "run"))
    EXPECT_EQ(counts.sent, counting.came[from_to].size())
        << from_to.first << " to " << from_to.second;
}

}  // namespace
}  // namespace arcbid::testing
