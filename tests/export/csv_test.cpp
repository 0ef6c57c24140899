// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/csv.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "core/base/error.hpp"
#include "sim/export/csv_export.hpp"
#include "tests/auction/fleet.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/export/recorded_run.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Row = std::map<std::string, std::string>;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// RFC 4180, read by its grammar.
std::vector<std::vector<std::string>> records_in(const std::string& text) {
  std::vector<std::vector<std::string>> records;
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char c = text[n];
    if (c == '"' && quoted && n + 1 < text.size() && text[n + 1] == '"')
      fields.back() += text[++n];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c == '\r' && !quoted && text[n + 1] == '\n')
      ++n, records.push_back(std::exchange(fields, std::vector<std::string>(1)));
    else
      fields.back() += c;
  }
  EXPECT_THAT(fields, ElementsAre("")) << "the last line does not end";
  return records;
}

std::vector<Row> rows_of(const std::filesystem::path& file) {
  const auto records = records_in(text_of(file));
  std::vector<Row> rows;
  for (std::size_t r = 1; r < records.size(); ++r) {
    EXPECT_EQ(records[r].size(), records[0].size()) << file << " line " << r + 1;
    Row& row = rows.emplace_back();
    for (std::size_t f = 0; f < std::min(records[r].size(), records[0].size()); ++f)
      row[records[0][f]] = records[r][f];
  }
  return rows;
}

TEST(CsvFile, QuotesWhatNeedsItAndNothingElse) {
  const Scratch scratch;
  CsvFile csv(scratch / "a.csv", "a,b");
  csv.row("plain", "with, comma");
  csv.row("say \"so\"", "two\r\nlines");
  csv.row(std::optional<int>(), 0.1);
  csv.close();
  EXPECT_EQ(text_of(scratch / "a.csv"),
            "a,b\r\nplain,\"with, comma\"\r\n\"say \"\"so\"\"\",\"two\r\nlines\"\r\n,0.1\r\n");
}

TEST(CsvFile, SaysWhereItCannotWrite) {
  const Scratch scratch;
  CsvFile csv(scratch / "nowhere/a.csv", "a");
  EXPECT_THROW(csv.close(), RunError);
}

/// A run of three of whom one dies and comes back, and what happened in it.
class CsvOfARun : public ::testing::Test {
 protected:
  CsvOfARun() {
    RecordedRun run(scratch / "run", random_mission(4, 3, 8));
    run.watch = [this](AgentId agent, const Step& step) { taken.emplace_back(agent, step); };
    run.run_for(1'000'000'000);
    run.kill({2});
    run.run_for(4'000'000'000);
    run.revive({2});
    run.run_for(2'000'000'000);
    run.end();
    export_csv(open_run(scratch / "run"), scratch / "csv");
  }
  std::vector<Row> rows(const std::string& table) const {
    return rows_of(scratch / ("csv/" + table + ".csv"));
  }
  template <class Visit>
  void each_sent(const Visit& visit) const {
    for (const auto& [agent, step] : taken) {
      for (const auto& bid : step.update.bids) visit("bid", bid.header);
      for (const auto& relay : step.update.relays) visit("relay", relay.header);
      for (const auto& status : step.update.statuses) visit("status", status.header);
    }
  }

  const Scratch scratch;
  std::vector<std::pair<AgentId, Step>> taken;
};

TEST_F(CsvOfARun, HasEveryDecision) {
  const auto decisions = rows("decisions");
  // The one that was killed may not have committed its last ones.
  std::map<std::string, std::size_t> made, written;
  for (const auto& [agent, step] : taken)
    if (step.update.decision) ++made[std::to_string(agent.value)];
  for (const Row& row : decisions) ++written[row.at("agent")];
  EXPECT_EQ(written["1"], made["1"]);
  EXPECT_EQ(written["3"], made["3"]);
  EXPECT_GT(written["2"], 0u);
  EXPECT_LE(written["2"], made["2"]);
  for (std::size_t d = 1; d < decisions.size(); ++d)
    EXPECT_LE(std::stod(decisions[d - 1].at("t_s")), std::stod(decisions[d].at("t_s")));
}

TEST_F(CsvOfARun, HasEveryClaimOfEveryStatementOnceBitForBit) {
  using Claimed = std::tuple<std::uint32_t, std::uint32_t, double>;  // agent, task, bid
  std::multiset<Claimed> made, written;
  std::map<AgentId, StatementKey> last;
  for (const auto& [agent, step] : taken) {
    if (agent == AgentId{2}) continue;
    const auto& decision = step.update.decision;
    if (!decision || decision->key <= last[agent]) continue;
    last[agent] = decision->key;
    for (const Claim& claim : std::get<Claims>(decision->body).bundle)
      made.emplace(agent.value, claim.task.value, claim.bid);
  }
  for (const Row& row : rows("bids"))
    if (row.at("agent") != "2")
      written.emplace(std::stoul(row.at("agent")), std::stoul(row.at("task")),
                      std::stod(row.at("bid")));
  EXPECT_GT(made.size(), 10u);
  EXPECT_EQ(written, made);
}

TEST_F(CsvOfARun, NamesEveryMessageAndWhoHeardIt) {
  std::set<std::string> sent, heard, made;
  for (const Row& row : rows("messages")) {
    const bool is_sent = row.at("direction") == "sent";
    (is_sent ? sent : heard)
        .insert(row.at("kind") + " " + row.at(is_sent ? "agent" : "peer") + " " +
                row.at("incarnation") + " " + row.at("sequence"));
  }
  each_sent([&](const char* kind, const Header& h) {
    made.insert(fmt::format("{} {} {} {}", kind, h.sender.value, h.incarnation, h.sequence));
  });
  EXPECT_GT(heard.size(), 20u);
  EXPECT_TRUE(std::includes(made.begin(), made.end(), sent.begin(), sent.end()));
  EXPECT_TRUE(std::includes(made.begin(), made.end(), heard.begin(), heard.end()));
}

TEST_F(CsvOfARun, OwnersLeadToWhatWasAgreed) {
  std::map<std::string, std::string> owner, bid;
  for (const Row& row : rows("owners")) {
    EXPECT_EQ(row.at("from_owner"), owner[row.at("task")]);
    owner[row.at("task")] = row.at("to_owner");
    bid[row.at("task")] = row.at("bid");
  }
  std::vector<Belief> agreed;
  for (const auto& [agent, step] : taken)
    if (step.update.agreed) agreed = step.update.agreed->winners;
  ASSERT_EQ(owner.size(), agreed.size());
  for (std::size_t j = 0; j < agreed.size(); ++j) {
    EXPECT_EQ(owner[std::to_string(j)], std::to_string(agreed[j].winner->value));
    EXPECT_EQ(std::stod(bid[std::to_string(j)]), agreed[j].bid);
  }
}

TEST_F(CsvOfARun, EventsSayWhoDiedAndCameBack) {
  std::vector<std::string> of_one;
  for (const Row& row : rows("events"))
    if (row.at("agent") == "1")
      of_one.push_back(row.at("event") +
                       (row.at("event") == "agreed" ? "" : " " + row.at("detail")));
  EXPECT_THAT(of_one, ElementsAre("started ", "agreed", "died 2", "reopened ", "agreed",
                                  "returned 2", "reopened ", "agreed"));
}

TEST_F(CsvOfARun, RoutesAreFlownAsLongAsTheyAre) {
  std::map<std::string, double> flown;
  for (const Row& row : rows("routes"))
    flown[row.at("agent") + " " + row.at("life") + " " + row.at("view")] =
        std::stod(row.at("flown_m"));
  std::size_t routes = 0;
  for (const LifeLog& life : open_run(scratch / "run").lives)
    for (const auto& [view, route] : life.routes()) {
      ++routes;
      EXPECT_NEAR(flown[fmt::format("{} {} {:016x}", life.agent().value, life.incarnation(), view)],
                  route.length_m, 1e-6);
    }
  EXPECT_EQ(flown.size(), routes);
}

TEST_F(CsvOfARun, TheSameRunGivesTheSameBytes) {
  export_csv(open_run(scratch / "run"), scratch / "again");
  for (const auto& file : csv_files(scratch / "csv"))
    EXPECT_EQ(text_of(file), text_of(scratch / "again" / file.filename()));
}

}  // namespace
}  // namespace arcbid::testing
