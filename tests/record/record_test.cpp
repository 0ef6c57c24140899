// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <limits>

#include "core/base/error.hpp"
#include "core/io/record/records.hpp"

namespace arcbid {
namespace {

using ::testing::HasSubstr;

Header header(std::uint32_t sender) {
  return {{sender},
          std::uint64_t{1'700'000'000'000} + sender,
          std::uint64_t{40} + sender,
          ~std::uint64_t{0},
          12};
}

/// Something in every field.
Step full_step() {
  Step step;
  const Claims claims{{{{4}, -0.1}, {{2}, std::numeric_limits<double>::denorm_min()}}};
  const Table table{{{AgentId{0}, 1.5}, {std::nullopt, 0}}, {7, ~std::uint64_t{0}}};
  const StatementKey key{99, true, 3};
  step.event = {-5, RelayMessage{header(3), {{2}, key, table}}};
  const NoBidder left{{3},  1.5, 2.5, NoBidderReason::endurance, Payload::camera, AgentId{2},
                      7.25, 6.5, 5};
  Update& u = step.update;
  u.bids = {{header(1), {{1}, key, claims}}};
  u.relays = {{header(1), {{2}, key, table}}};
  StatusMessage status;
  status.header = header(1);
  status.phase = Phase::routed;
  status.ready = {{1}, {2}};
  status.view = {{{2}, key}};
  status.heartbeats = {{{2}, {5, 6}}};
  u.statuses = {status};
  u.refused = "why not";
  u.died = {{4}};
  u.returned = {{5}};
  u.decision = DecisionMade{3, true, key, claims, {{{4}, true}, {{2}, false}}};
  u.started = u.agreement_lost = true;
  u.agreed =
      Agreement{8, 9, {{1}}, {{AgentId{1}, -0.0}}, {{{4}, true}}, {{{7}, {{4}, {2}}}}, {left}};
  u.wake_ns = std::numeric_limits<TimeNs>::min();
  return step;
}

TEST(Record, ReadsBackToTheSameBits) {
  const std::string bytes = encode(full_step());
  const Step again = decode<Step>(bytes);
  EXPECT_EQ(encode(again), bytes);
  EXPECT_EQ(again.update.wake_ns, std::numeric_limits<TimeNs>::min());
  EXPECT_EQ(std::get<Table>(std::get<RelayMessage>(again.event.what).statement.body).beliefs,
            (std::vector<Belief>{{AgentId{0}, 1.5}, {std::nullopt, 0}}));
  EXPECT_TRUE(std::signbit(again.update.agreed->winners[0].bid));
  EXPECT_EQ(again.update.decision->path[0], (PathStop{{4}, true}));
  EXPECT_EQ(again.update.statuses[0].heartbeats[0], (Pulse{{2}, {5, 6}}));
}

TEST(Record, EveryEventReadsBackAsTheSameKind) {
  const std::vector<Event> events{{1, Tick{7}},
                                  {2, BidMessage{header(1), {{1}, {1, false, 1}, Claims{}}}},
                                  {3, RelayMessage{header(1), {{2}, {1, false, 1}, Table{}}}},
                                  {4, StatusMessage{}},
                                  {5, RoutePublished{6}}};
  for (const Event& event : events)
    EXPECT_EQ(decode<Step>(encode(Step{event, {}})).event.what.index(), event.what.index());
}

TEST(Record, EqualRecordsHaveEqualBytesWhateverWasEncodedBefore) {
  const std::string small = encode(Step{{1, Tick{2}}, {}});
  const std::string large = encode(full_step());
  EXPECT_EQ(encode(Step{{1, Tick{2}}, {}}), small);
  EXPECT_EQ(encode(full_step()), large);
}

TEST(Record, HoldsMoreThanTheRoomItBeganWith) {
  Mission mission;
  mission.name = "large";
  mission.arcs.resize(300);
  for (std::uint32_t a = 0; a < 300; ++a) {
    mission.arcs[a].id = {a};
    mission.arcs[a].waypoints.resize(9, {Vec3(a, 0.1, -3), Vec3(0, 0, 1)});
  }
  mission.fleet = {{{7}, Vec3(1, 2, 3), 2.5}};
  mission.airspace = {
      Vec3(0, 1, 3), 0.5, {4, 3, 2}, {20, 4}, {{{2}, 1, {AccessPoint{Vec3(1, 0, 0)}}}}};
  mission.auction.split_m = 0.1;
  const Mission again = decode<Mission>(encode(mission));
  EXPECT_EQ(digest(again), digest(mission));
  EXPECT_EQ(again.auction.split_m, 0.1);
}

/// Whatever a damaged log holds: refused in one line, or read; never anything else.
TEST(Record, SurvivesEveryTruncationAndEveryChangedByte) {
  const std::string bytes = encode(full_step());
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_THROW(decode<Step>(std::string_view(bytes).substr(0, n)), InputError) << n;
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (const char bit : {'\x01', '\x80'}) {
      std::string damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ bit);
      try {
        decode<Step>(damaged);
      } catch (const InputError&) {
      }
    }
}

TEST(Record, SaysWhichFieldIsWrong) {
  Step step;
  step.event = {1, StatusMessage{}};
  std::get<StatusMessage>(step.event.what).phase = static_cast<Phase>(9);
  try {
    decode<Step>(encode(step));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("field phase: 9, legal: 0 to 4"));
  }
}

TEST(Record, HasASchemaThatDefinesAllItUsesOnce) {
  const std::string schema = schema_of<BidMessage>();
  EXPECT_TRUE(schema.starts_with("arcbid_msgs/Header header\narcbid_msgs/Statement statement\n"));
  EXPECT_THAT(schema, HasSubstr("MSG: arcbid_msgs/Claim\nuint32 task\nfloat64 bid\n"));
  EXPECT_THAT(schema, HasSubstr("MSG: arcbid_msgs/Belief\nint64 winner\nfloat64 bid\n"));
  EXPECT_THAT(schema, HasSubstr("arcbid_msgs/Claims[<=1] claims\narcbid_msgs/Table[<=1] table\n"));
  const auto first = schema.find("MSG: arcbid_msgs/Belief\n");
  EXPECT_EQ(schema.find("MSG: arcbid_msgs/Belief\n", first + 1), std::string::npos);
}

TEST(Record, IsShownToPeopleFieldByField) {
  const auto shown = to_json(full_step());
  EXPECT_EQ(shown["event"]["relay"]["statement"]["table"]["beliefs"][1]["winner"], nullptr);
  EXPECT_EQ(shown["event"]["relay"]["header"]["sequence"], 43);
  EXPECT_EQ(shown["event"]["relay"]["header"]["mission_digest"], "ffffffffffffffff");
  EXPECT_EQ(shown["update"]["decision"]["claims"]["bundle"][0]["bid"], -0.1);
}

}  // namespace
}  // namespace arcbid
