// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace arcbid {
namespace {

class RunLockTest : public ::testing::Test {
 protected:
  RunLockTest() {
    std::string folder = (std::filesystem::temp_directory_path() / "run_lock.XXXXXX").string();
    run = mkdtemp(folder.data());
  }
  ~RunLockTest() override { std::filesystem::remove_all(run); }
  std::filesystem::path run;
};

TEST_F(RunLockTest, SaysThatARunGoesOnWhileItIsHeld) {
  EXPECT_FALSE(goes_on(run));
  {
    const RunLock lock(run / "new");
    EXPECT_TRUE(goes_on(run / "new"));
    EXPECT_TRUE(goes_on(run / "new")) << "to ask takes nothing away";
  }
  EXPECT_FALSE(goes_on(run / "new"));
  EXPECT_TRUE(std::filesystem::is_empty(run / "new"));
}

TEST_F(RunLockTest, EndsWithTheResult) {
  const RunLock lock(run);
  std::ofstream(run / "result.json") << "{}";
  EXPECT_FALSE(goes_on(run));
}

TEST_F(RunLockTest, IsLetGoWhenItsProcessIsKilled) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t launcher = fork();
  if (launcher == 0) {
    const RunLock lock(run);
    if (write(ready[1], "!", 1) == 1)
      for (;;) pause();
    _exit(1);
  }
  char held = 0;
  ASSERT_EQ(read(ready[0], &held, 1), 1);
  EXPECT_TRUE(goes_on(run));
  kill(launcher, SIGKILL);
  waitpid(launcher, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(run / "running"));
  EXPECT_FALSE(goes_on(run));
  close(ready[0]);
  close(ready[1]);
}

}  // namespace
}  // namespace arcbid
