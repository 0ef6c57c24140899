// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/agent_log.hpp"

#include <gmock/gmock.h>
#include <stdlib.h>

#include "core/io/run/run_log_reader.hpp"

namespace arcbid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr TimeNs ms = 1'000'000;
const AgentLog::Life life{{3}, 17, 5};

class AgentLogTest : public ::testing::Test {
 protected:
  AgentLogTest() {
    std::string folder = (std::filesystem::temp_directory_path() / "agent_log.XXXXXX").string();
    folder_ = mkdtemp(folder.data());
  }
  ~AgentLogTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file() const { return folder_ / "log.sqlite"; }
  /// What another process can read: kinds in their order, with their times in ms.
  std::vector<std::string> committed() const {
    std::vector<std::string> out;
    RunLogReader(file()).read([&out](const RunLogReader::Record& record) {
      out.push_back(std::string(record.kind) + " " + std::to_string(record.t_ns / ms));
      return true;
    });
    return out;
  }

  std::filesystem::path folder_;
};

Step tick(std::uint32_t peers) {
  return {{100 * ms, Tick{peers}}, {}};
}

TEST_F(AgentLogTest, WritesWhatRoundsLeaveTogetherAndInOrder) {
  AgentLog log(file(), life, {});
  log.step(100 * ms, tick(3));
  log.write(101 * ms, "lost", {{"sender", 2}});
  EXPECT_EQ(log.due_ns(), 180 * ms);
  log.commit_if_due(179 * ms);
  EXPECT_THAT(committed(), IsEmpty());
  log.commit_if_due(180 * ms);
  EXPECT_THAT(committed(), ElementsAre("step 100", "lost 101"));
  EXPECT_EQ(log.due_ns(), std::nullopt);
}

TEST_F(AgentLogTest, HasTheMissionOnRecordBeforeTheAuction) {
  AgentLog log(file(), life, {});
  Mission mission;
  mission.name = "a bridge";
  log.birth(90 * ms, {{3}, 17, 80 * ms}, mission);
  EXPECT_THAT(committed(), ElementsAre("mission 90", "birth 90"));
  const RunLogReader reader(file());
  EXPECT_EQ(decode<Mission>(reader.first("mission")->body).name, "a bridge");
  EXPECT_EQ(decode<Birth>(reader.first("birth")->body).now_ns, 80 * ms);
}

TEST_F(AgentLogTest, SaysWhoseLifeItIsAndWhatWroteIt) {
  AgentLog log(file(), life, {});
  const RunLogReader reader(file());
  EXPECT_EQ(reader.meta("process")["agent"], 3);
  EXPECT_EQ(reader.meta("process")["incarnation"], 17);
  EXPECT_EQ(reader.meta("seed"), 5);
  EXPECT_FALSE(reader.meta("build")["version"].get<std::string>().empty());
}

TEST_F(AgentLogTest, HasTheSchemaOfEveryRecord) {
  AgentLog log(file(), life, {});
  log.step(1, tick(3));
  log.commit();
  const RunLogReader reader(file());
  ASSERT_EQ(reader.kinds().size(), 1u);
  EXPECT_EQ(reader.kinds()[0].encoding, "cdr");
  EXPECT_EQ(reader.kinds()[0].schema, schema_of<Step>());
}

TEST_F(AgentLogTest, WritesWhatIsKeptWhenItsAgentGoesHoweverThatHappens) {
  try {
    AgentLog log(file(), life, {});
    log.step(100 * ms, tick(3));
    throw std::runtime_error("a second process with this id");
  } catch (const std::runtime_error&) {
  }
  EXPECT_THAT(committed(), ElementsAre("step 100"));
}

TEST_F(AgentLogTest, CostsNothingWithoutAFile) {
  AgentLog log(std::nullopt, life, {});
  log.step(100 * ms, tick(3));
  EXPECT_EQ(log.due_ns(), std::nullopt);
  log.write(101 * ms, "lost", {});
  log.commit();
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(AgentLogTest, TellsWhatLinksDidToAMessage) {
  Header header;
  header.sender = {4};
  header.incarnation = 17;
  header.sequence = 9;
  std::vector<std::string> bodies;
  {
    AgentLog log(file(), life, {});
    log.fate(5 * ms, header, {5 * ms});
    log.fate(6 * ms, header, {});
    log.fate(7 * ms, header, {7 * ms, 9 * ms});
    log.fate(8 * ms, header, {10 * ms});
  }
  RunLogReader(file()).read([&bodies](const RunLogReader::Record& record) {
    bodies.push_back(std::string(record.kind) + " " + std::string(record.body));
    return true;
  });
  EXPECT_THAT(
      bodies,
      ElementsAre(R"(lost {"incarnation":17,"sender":4,"sequence":9})",
                  R"(fate {"after_ns":[0,2000000],"incarnation":17,"sender":4,"sequence":9})",
                  R"(fate {"after_ns":[2000000],"incarnation":17,"sender":4,"sequence":9})"));
}

}  // namespace
}  // namespace arcbid
