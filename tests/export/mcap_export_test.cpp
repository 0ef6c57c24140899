// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/mcap_export.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <numeric>

#include "sim/export/scene.hpp"
#include "tests/auction/fleet.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/export/recorded_run.hpp"
#include "tests/mcap/records_of.hpp"

namespace arcbid::testing {
namespace {

using mcap_test::contents;

constexpr int channel_record = 0x04, attachment_record = 0x09;

class McapOfARun : public ::testing::Test {
 protected:
  McapOfARun() : file(scratch / "run.mcap") {
    RecordedRun run(scratch / "run", random_mission(4, 3, 8));
    run.watch = [this](AgentId agent, const Step& step) { taken[agent].push_back(encode(step)); };
    run.run_for(1'000'000'000);
    run.end();
    std::ofstream(scratch / "run/result.json") << "{\"schema\": 1}\n";
    export_mcap(open_run(scratch / "run"), file);
    for (const auto& channel : mcap_test::only(mcap_test::records_of(file), channel_record)) {
      auto fields = channel.fields();
      const auto id = fields.number(2);
      fields.number(2);
      topics[fields.string()] = id;
    }
  }
  std::vector<mcap_test::Message> on(const std::string& topic) const {
    std::vector<mcap_test::Message> out;
    for (const auto& message : mcap_test::messages_of(file))
      if (message.channel == topics.at(topic)) out.push_back(message);
    return out;
  }

  const Scratch scratch;
  const std::filesystem::path file;
  std::map<AgentId, std::vector<std::string>> taken;
  std::map<std::string, std::uint64_t> topics;
};

TEST_F(McapOfARun, HasEveryStepAsItIsOnRecord) {
  for (const auto& [agent, steps] : taken) {
    std::vector<std::string> written;
    for (const auto& message : on(fmt::format("/agent_{}/step", agent.value)))
      written.push_back(message.data);
    EXPECT_EQ(written, steps);
  }
}

TEST_F(McapOfARun, HasEveryMessageUnderItsOwnNumber) {
  std::vector<std::uint64_t> numbers, expected;
  for (const char* kind : {"bid", "relay", "status"})
    for (const auto& message : on(std::string("/agent_2/sent/") + kind))
      numbers.push_back(message.sequence);
  std::sort(numbers.begin(), numbers.end());
  expected.resize(numbers.size());
  std::iota(expected.begin(), expected.end(), 1);
  EXPECT_GT(numbers.size(), 5u);
  EXPECT_EQ(numbers, expected);
  const auto bid = decode<BidMessage>(on("/agent_2/sent/bid").front().data);
  EXPECT_EQ(bid.header.sender, AgentId{2});
  EXPECT_EQ(bid.header.sequence, on("/agent_2/sent/bid").front().sequence);
}

TEST_F(McapOfARun, TimeDoesNotGoBack) {
  std::uint64_t last = 0;
  for (const auto& message : mcap_test::messages_of(file)) {
    EXPECT_LE(last, message.log_time);
    last = message.log_time;
  }
}

TEST_F(McapOfARun, DronesFlyFromHomeToHomeFromTheAgreementOn) {
  std::uint64_t agreed_ns = 0;
  for (const auto& event : on("/events"))
    if (event.data.find("agreed") != std::string::npos) agreed_ns = event.log_time;
  const RunArchive run = open_run(scratch / "run");
  const PlannedRoute planned = run.lives[0].routes().back();
  const auto poses = on("/agent_1/pose");
  ASSERT_EQ(poses.size(), static_cast<std::size_t>(std::ceil(planned.route.time_s * 2)) + 1);
  EXPECT_EQ(poses.front().log_time, agreed_ns);
  EXPECT_EQ(poses[1].log_time, agreed_ns + 500'000'000);
  const Flight flight(planned.route);
  const Vec3 home = run.mission->fleet[0].home_m;
  for (const double at_s : {0.0, planned.route.time_s}) {
    const auto [x, y, z] = flight.pose(at_s).position;
    EXPECT_LT((Vec3(x, y, z) - home).norm(), 1e-6);
  }
}

TEST_F(McapOfARun, PosesLookWhereTheSensorLooks) {
  const PlannedRoute planned = open_run(scratch / "run").lives[0].routes().back();
  for (const auto& pose : Scene::path(0, planned.route).poses) {
    const auto& q = pose.pose.orientation;
    const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
    EXPECT_LT((turn * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-9);  // all look along x here
  }
  Route up{
      {{std::nullopt, 0, 0, {{Vec3::Zero(), Vec3(0, 0.6, 0.8)}, {Vec3::UnitX(), Vec3::UnitZ()}}}},
      1,
      1,
      0,
      0,
      0};
  const auto& q = Flight(up).pose(0).orientation;
  EXPECT_LT((Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Vec3::UnitX() - Vec3(0, 0.6, 0.8)).norm(),
            1e-9);
}

TEST_F(McapOfARun, ArcsAreDrawnWholeInTheColoursOfTheirOwners) {
  const RunArchive run = open_run(scratch / "run");
  const Scene scene(*run.mission, run.tasks);
  std::vector<Belief> owners(run.tasks.tasks.size());
  owners[0] = {AgentId{2}, -1};
  const auto markers = scene.arcs(7, owners).markers;
  ASSERT_EQ(markers.size(), 3u);  // away with the old ones, nobody's, agent 2's
  EXPECT_EQ(markers[0].action, ros::MarkerAction::remove_all);
  EXPECT_EQ(markers[2].id, 2);
  EXPECT_EQ(markers[2].points.size(), 2u);
  EXPECT_EQ(markers[1].points.size(), 2 * (owners.size() - 1));  // the arcs here are straight
  const auto homes = scene.homes(0).markers;
  EXPECT_EQ(markers[2].color.r, homes[2].color.r);
  EXPECT_NE(markers[2].color.r, markers[1].color.r);
}

TEST_F(McapOfARun, CarriesTheFilesThatAreThere) {
  const auto attachments = mcap_test::only(mcap_test::records_of(file), attachment_record);
  ASSERT_EQ(attachments.size(), 1u);
  EXPECT_NE(attachments[0].content.find("{\"schema\": 1}\n"), std::string::npos);
}

TEST_F(McapOfARun, TheSameRunGivesTheSameBytes) {
  export_mcap(open_run(scratch / "run"), scratch / "again.mcap");
  EXPECT_EQ(contents(file), contents(scratch / "again.mcap"));
}

}  // namespace
}  // namespace arcbid::testing
