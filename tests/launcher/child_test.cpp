// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/child.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

void wait_for(Child& child) {
  for (int tries = 0; tries < 500 && child.running(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    child.poll();
  }
}

TEST(Child, GivesWholeLinesAndTheExitCode) {
  Child child("shell", {"/bin/sh", "-c", "printf 'one\\ntwo\\nhal'; exit 3"});
  wait_for(child);
  EXPECT_EQ(child.read_lines(), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(child.exit_code(), 3);
  EXPECT_FALSE(child.ended_by_signal());
  EXPECT_EQ(child.output(), -1) << "the pipe has ended";
}

TEST(Child, TellsWhichSignalEndedIt) {
  Child child("sleeper", {"/bin/sleep", "30"});
  EXPECT_TRUE(child.running());
  child.signal(SIGKILL);
  wait_for(child);
  EXPECT_EQ(child.ended_by_signal(), SIGKILL);
  EXPECT_FALSE(child.exit_code());
}

TEST(Child, EndsWithTheObject) {
  pid_t pid = 0;
  {
    const Child child("sleeper", {"/bin/sleep", "30"});
    pid = child.pid();
  }
  EXPECT_NE(kill(pid, 0), 0);
}

TEST(Child, SaysWhatCannotBeStarted) {
  EXPECT_THROW(Child("ghost", {"/no/such/program"}), InputError);
}

}  // namespace
}  // namespace arcbid
