// SPDX-License-Identifier: GPL-3.0-or-later
// arcbid replay --dds, heard over real Fast DDS on loopback.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <thread>

#include "agent/recorded_messages.hpp"
#include "core/io/domain/domain.hpp"
#include "idl/bus.hpp"
#include "tests/replay/older_run.hpp"
#include "tests/replay/recorded_fleet.hpp"

namespace arcbid {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr TimeNs s = 1'000'000'000;
constexpr std::uint32_t fleet_size = 3;

/// `arcbid replay RUN --dds`, ended with its owner.
class Replayer {
 public:
  Replayer(const std::filesystem::path& run, std::uint32_t domain) : said_(run / "said") {
    const std::string program = ARCBID_BIN_DIR "/arcbid", where = std::to_string(domain);
    pid_ = fork();
    if (pid_ != 0) return;
    if (freopen(said_.c_str(), "w", stderr) == nullptr) _exit(126);
    if (freopen("/dev/null", "w", stdout) == nullptr) _exit(126);
    execl(program.c_str(), "arcbid", "replay", run.c_str(), "--dds", "--domain", where.c_str(),
          "--rate", "4", static_cast<char*>(nullptr));
    _exit(127);
  }
  ~Replayer() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  /// Its exit code once it has ended.
  std::optional<int> ended() {
    int status = 0;
    if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// On standard error.
  std::string said() const {
    std::ifstream in(said_);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path said_;
  pid_t pid_ = 0;
};

class ReplayerTest : public ::testing::Test {
 protected:
  ReplayerTest() {
    testing::RecordedFleet fleet(testing::random_mission(3, fleet_size, 5), folder_.path(), 3);
    EXPECT_TRUE(fleet.run(60 * s));
    fleet.end();
  }
  testing::TemporaryFolder folder_;
  DomainLease lease_{fleet_size + 1};
  NetworkConfig network_;
};

TEST_F(ReplayerTest, TellsAListenerTheMissionAndWhatEveryAgentSaid) {
  const RecordedMessages record(folder_.path());
  std::map<AgentId, std::set<std::uint64_t>> bids, heard;
  record.play([&](TimeNs, const AgentMessage& message) {
    if (const auto* bid = std::get_if<BidMessage>(&message))
      bids[bid->header.sender].insert(bid->header.sequence);
    return true;
  });
  ASSERT_EQ(bids.size(), fleet_size);
  Bus listener(network_, lease_.domain(), AgentId{99}, fleet_size + 1);
  Replayer replayer(folder_.path(), lease_.domain());
  std::optional<Mission> mission;
  std::optional<int> exit;
  std::size_t statuses = 0;
  for (const auto deadline = Clock::now() + 40s; !exit && Clock::now() < deadline;) {
    exit = replayer.ended();
    for (const Received& received : listener.wait(20ms)) {
      if (const auto* one = std::get_if<Mission>(&received)) mission = *one;
      if (std::holds_alternative<StatusMessage>(received)) ++statuses;
      if (const auto* bid = std::get_if<BidMessage>(&received))
        heard[bid->header.sender].insert(bid->header.sequence);
    }
  }
  ASSERT_EQ(exit, 0) << replayer.said();
  ASSERT_TRUE(mission);
  EXPECT_EQ(digest(*mission), digest(record.mission()));
  EXPECT_GT(statuses, 0u);
  EXPECT_EQ(heard, bids);
}

TEST_F(ReplayerTest, SaysWhenAnotherArcbidRecordedTheRun) {
  testing::make_older(folder_.path(), testing::otherwise);
  Replayer replayer(folder_.path(), lease_.domain());
  std::optional<int> exit;
  for (const auto deadline = Clock::now() + 40s; !exit && Clock::now() < deadline;) {
    exit = replayer.ended();
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_EQ(exit, 0);
  EXPECT_THAT(replayer.said(), ::testing::HasSubstr("may refuse its messages: written by arcbid "
                                                    "0.0.9 01dbeef"));
}

TEST_F(ReplayerTest, DisturbsNobodyWhoSpeaksThere) {
  Bus busy(network_, lease_.domain(), AgentId{1}, fleet_size);
  Replayer replayer(folder_.path(), lease_.domain());
  std::optional<int> exit;
  std::uint64_t sequence = 0;
  for (const auto deadline = Clock::now() + 40s; !exit && Clock::now() < deadline;) {
    exit = replayer.ended();
    StatusMessage status;
    status.header = {{1}, 7, ++sequence, 0, 0};
    busy.publish(status);
    for (const Received& received : busy.wait(20ms))
      EXPECT_TRUE(std::holds_alternative<Malformed>(received)) << "it said something";
  }
  EXPECT_EQ(exit, 2);
  EXPECT_THAT(replayer.said(), ::testing::HasSubstr("somebody speaks there"));
}

}  // namespace
}  // namespace arcbid
