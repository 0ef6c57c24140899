// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

class RunLogTest : public ::testing::Test {
 protected:
  RunLogTest() {
    std::string name = (std::filesystem::temp_directory_path() / "arcbid-log-XXXXXX").string();
    directory = mkdtemp(name.data());
    file = directory / "log.sqlite";
  }
  ~RunLogTest() override { std::filesystem::remove_all(directory); }

  int count() const {
    sqlite3* db = nullptr;
    sqlite3_stmt* statement = nullptr;
    sqlite3_open(file.c_str(), &db);
    sqlite3_prepare_v2(db, "SELECT count(*) FROM events", -1, &statement, nullptr);
    sqlite3_step(statement);
    const int rows = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return rows;
  }
  std::filesystem::path directory, file;
};

TEST_F(RunLogTest, KeepsEverythingWhenItIsClosed) {
  {
    RunLog log(file);
    for (int n = 0; n < 100; ++n) log.append(n, "tick", {{"n", n}});
  }
  EXPECT_EQ(count(), 100);
  EXPECT_FALSE(std::filesystem::exists(file.string() + "-wal")) << "a log is one file once closed";
}

TEST_F(RunLogTest, KeepsWhatWasCommittedWhenTheProcessIsKilled) {
  const pid_t child = fork();
  if (child == 0) {
    RunLog log(file);
    for (int n = 0; n < 50; ++n) log.append(n, "tick", {{"n", n}});
    log.commit();
    log.append(50, "tick", {{"n", 50}});
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_EQ(count(), 50);
}

TEST_F(RunLogTest, CommitsByItselfAsTimeGoesBy) {
  const pid_t child = fork();
  if (child == 0) {
    RunLog log(file);
    for (TimeNs now = 0; now <= 1'000'000'000; now += 10'000'000) {
      log.append(now, "tick", {});
      log.commit_if_due(now);
    }
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_GE(count(), 92) << "no more than the last 80 ms may be lost";
}

TEST_F(RunLogTest, SaysWhichFileCannotBeWritten) {
  try {
    RunLog log("/proc/no/such/log.sqlite");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/proc/no/such"), std::string::npos);
  }
}

}  // namespace
}  // namespace arcbid
