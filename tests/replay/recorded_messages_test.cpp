// SPDX-License-Identifier: GPL-3.0-or-later
// What arcbid replay --dds says again, of sound and of damaged logs.
#include "agent/recorded_messages.hpp"

#include <numeric>

#include "core/base/error.hpp"
#include "tests/replay/damaged_run.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Numbers of the messages said, by their sender.
using Said = std::map<AgentId, std::vector<std::uint64_t>>;

class RecordedMessagesTest : public DamagedRun {
 protected:
  Said said() const {
    Said out;
    RecordedMessages(run).play([&out](TimeNs, const AgentMessage& message) {
      const Header header = std::visit([](const auto& m) { return m.header; }, message);
      out[header.sender].push_back(header.sequence);
      return true;
    });
    return out;
  }
  std::vector<std::string> left_out() const { return RecordedMessages(run).left_out(); }
  std::int64_t number_of(std::string_view kind) const {
    std::int64_t seq = 0;
    RunLogReader(log).read(
        [&seq](const RunLogReader::Record& record) {
          seq = record.seq;
          return false;
        },
        0, kind);
    return seq;
  }
};

TEST_F(RecordedMessagesTest, HaveAllThatWasSaidUnderEveryPolicy) {
  for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::claims_keep, PolicyKind::cbba,
                                  PolicyKind::cbba_rebuild, PolicyKind::acbba}) {
    std::filesystem::remove_all(run);
    Mission mission = random_mission(4, 3, 8);
    mission.auction.policy = policy;
    RecordedRun recorded(run, mission);
    std::map<AgentId, std::size_t> sent;
    recorded.watch = [&sent](AgentId agent, const Step& step) {
      const Update& u = step.update;
      sent[agent] += u.bids.size() + u.relays.size() + u.statuses.size();
    };
    recorded.run_for(3'000'000'000);
    recorded.end();
    EXPECT_THAT(left_out(), IsEmpty()) << name_of(policy);
    Said heard = said();
    ASSERT_EQ(sent.size(), 3u) << name_of(policy);
    for (const auto& [agent, count] : sent) {
      std::vector<std::uint64_t> all(count);
      std::iota(all.begin(), all.end(), 1);
      EXPECT_GT(count, 0u);
      EXPECT_EQ(heard[agent], all) << name_of(policy);
    }
  }
}

TEST_F(RecordedMessagesTest, GoOnBehindAGap) {
  record();
  const Said whole = said();
  std::string bytes = bytes_of(log);
  const std::size_t page = 4096;
  bytes.replace(bytes.size() / page / 2 * page, page, page, '\0');
  put_bytes(log, bytes);
  const Said left = said();
  EXPECT_EQ(left.at({1}), whole.at({1}));
  EXPECT_EQ(left.at({3}), whole.at({3}));
  EXPECT_LT(left.at({2}).size(), whole.at({2}).size());
  EXPECT_EQ(left.at({2}).front(), whole.at({2}).front());
  EXPECT_EQ(left.at({2}).back(), whole.at({2}).back());
  EXPECT_THAT(left_out(), ElementsAre(HasSubstr(log.filename().string() + ": record ")));
}

TEST_F(RecordedMessagesTest, AreOfOneMission) {
  record();
  const auto elsewhere = folder / "elsewhere";
  RecordedRun other(elsewhere, random_mission(5, 3, 8));
  other.run_for(1'000'000'000);
  const auto foreign = other.log({2});
  other.end();
  std::filesystem::copy_file(foreign, run / "logs/agent_9.1.sqlite");
  try {
    said();
    ADD_FAILURE() << "was not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("agent_9.1.sqlite: mission "));
    EXPECT_THAT(error.what(), HasSubstr("but the other logs have "));
  }
}

TEST_F(RecordedMessagesTest, DoNotHaveAMissionThatNobodySpokeOf) {
  record();
  Mission damaged = random_mission(4, 3, 20);
  damaged.fleet.back().id.value += 1 << 20;
  put_record(log, number_of("mission"), encode(damaged));
  const RecordedMessages messages(run);
  EXPECT_EQ(messages.fleet().back(), AgentId{3});
  EXPECT_THAT(messages.left_out(), ElementsAre(HasSubstr("its messages name mission")));
  EXPECT_FALSE(said().contains({2}));
}

TEST_F(RecordedMessagesTest, DoNotHaveABidInAnotherAgentsName) {
  record();
  std::optional<std::int64_t> seq;
  Step step;
  for (auto at = records.begin(); !seq && at != records.end(); ++at) try {
      step = decode<Step>(at->second);
      if (!step.update.bids.empty()) seq = at->first;
    } catch (const InputError&) {  // not a step
    }
  ASSERT_TRUE(seq);
  step.update.bids.front().statement.agent = {1};
  put_record(log, *seq, encode(step));
  EXPECT_THAT(left_out(), ElementsAre(HasSubstr("in another agent's name")));
  EXPECT_GT(said().at({2}).size(), 1u);
}

}  // namespace
}  // namespace arcbid::testing
