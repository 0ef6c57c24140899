// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/agent_log.hpp"

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <stdlib.h>

namespace arcbid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr TimeNs ms = 1'000'000;

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
    sqlite3* db = nullptr;
    EXPECT_EQ(sqlite3_open_v2(file().c_str(), &db, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
    sqlite3_stmt* rows = nullptr;
    EXPECT_EQ(
        sqlite3_prepare_v2(db, "SELECT kind, t_ns FROM events ORDER BY seq", -1, &rows, nullptr),
        SQLITE_OK);
    std::vector<std::string> out;
    while (sqlite3_step(rows) == SQLITE_ROW)
      out.push_back(std::string(reinterpret_cast<const char*>(sqlite3_column_text(rows, 0))) + " " +
                    std::to_string(sqlite3_column_int64(rows, 1) / ms));
    sqlite3_finalize(rows);
    sqlite3_close(db);
    return out;
  }

  std::filesystem::path folder_;
};

TEST_F(AgentLogTest, WritesWhatRoundsLeaveTogetherAndInOrder) {
  AgentLog log(file(), {});
  log.commit();
  log.keep(100 * ms, Event{100 * ms, Tick{3}});
  log.keep(101 * ms, DecisionMade{});
  EXPECT_EQ(log.due_ns(), 180 * ms);
  log.write_if_due(179 * ms);
  EXPECT_THAT(committed(), IsEmpty());
  log.write_if_due(180 * ms);
  EXPECT_THAT(committed(), ElementsAre("tick 100", "decision 101"));
  EXPECT_EQ(log.due_ns(), std::nullopt);
}

TEST_F(AgentLogTest, WritesNothingAheadOfWhatIsKept) {
  AgentLog log(file(), {});
  log.keep(100 * ms, Event{100 * ms, Tick{3}});
  log.write(105 * ms, "died", {{"agents", {2}}});
  log.keep(106 * ms, StatusMessage{});
  log.commit();
  EXPECT_THAT(committed(), ElementsAre("tick 100", "died 105", "sent_status 106"));
}

TEST_F(AgentLogTest, WritesWhatIsKeptWhenItsAgentGoesHoweverThatHappens) {
  try {
    AgentLog log(file(), {});
    log.keep(100 * ms, Agreement{});
    throw std::runtime_error("a second process with this id");
  } catch (const std::runtime_error&) {
  }
  EXPECT_THAT(committed(), ElementsAre("agreed 100"));
}

TEST_F(AgentLogTest, CostsNothingWithoutAFile) {
  AgentLog log(std::nullopt, {});
  log.keep(100 * ms, Agreement{});
  EXPECT_EQ(log.due_ns(), std::nullopt);
  log.write(101 * ms, "died", {});
  log.commit();
  EXPECT_FALSE(std::filesystem::exists(file()));
}

}  // namespace
}  // namespace arcbid
