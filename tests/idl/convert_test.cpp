// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/convert.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "idl/endpoint.hpp"
#include "tests/idl/equal.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// As a reader would get it: serialised, and decoded by the guarded type.
template <class Message>
auto through_cdr(const Message& message) {
  GuardedType<typename Topic<Message>::Type> type;
  auto sample = to_wire(message);
  eprosima::fastrtps::rtps::SerializedPayload_t payload(type.getSerializedSizeProvider(&sample)());
  EXPECT_TRUE(type.serialize(&sample, &payload));
  decltype(sample) back;
  EXPECT_TRUE(type.deserialize(&payload, &back));
  return from_wire(back);
}

template <class Message>
void expect_round_trip(const Message& message) {
  const auto back = through_cdr(message);
  ASSERT_TRUE(std::holds_alternative<Message>(back)) << std::get<std::string>(back);
  EXPECT_TRUE(same(std::get<Message>(back), message));
}

template <class Sample>
std::string refusal(const Sample& sample) {
  const auto decoded = from_wire(sample);
  const auto* reason = std::get_if<std::string>(&decoded);
  return reason ? *reason : "accepted";
}

TEST(Convert, RoundTripIsBitExact) {
  expect_round_trip(samples::mission());
  expect_round_trip(samples::control());
  expect_round_trip(samples::bids(3));
  expect_round_trip(BidMessage{samples::header(2), samples::table(2)});
  expect_round_trip(samples::relay(3, 2));
  expect_round_trip(RelayMessage{samples::header(2), samples::claims(1)});
  expect_round_trip(samples::status(4));
  expect_round_trip(samples::route(5));
}

TEST(Convert, RoundTripOfEmptyAndAbsent) {
  Mission mission = samples::mission();
  mission.name.clear();
  mission.auction.split_m.reset();
  expect_round_trip(mission);
  expect_round_trip(BidMessage{samples::header(2), {AgentId{2}, {}, Claims{}}});
  expect_round_trip(BidMessage{samples::header(2), {AgentId{2}, {}, Table{}}});
  expect_round_trip(
      StatusMessage{samples::header(1), Phase::waiting_for_mission, 0, 0, 0, {}, true, {}, {}});
  expect_round_trip(RouteMessage{samples::header(1), 0, 0, 0, 0, {}});
  expect_round_trip(ControlMessage{});
}

TEST(Convert, ForeignSchemaVersionIsRefused) {
  wire::Mission mission = to_wire(samples::mission());
  mission.schema_version(2);
  EXPECT_THAT(refusal(mission), HasSubstr("schema_version = 2"));
  wire::Control control = to_wire(samples::control());
  control.schema_version(7);
  EXPECT_THAT(refusal(control), HasSubstr("schema_version = 7"));
  wire::Bids bids = to_wire(samples::bids(1));
  bids.header().schema_version(2);
  EXPECT_THAT(refusal(bids), HasSubstr("schema_version = 2"));
  wire::Relay relay = to_wire(samples::relay(1, 2));
  relay.header().schema_version(2);
  EXPECT_THAT(refusal(relay), HasSubstr("schema_version = 2"));
  wire::Status status = to_wire(samples::status(1));
  status.header().schema_version(2);
  EXPECT_THAT(refusal(status), HasSubstr("schema_version = 2"));
  wire::Route route = to_wire(samples::route(1));
  route.header().schema_version(2);
  EXPECT_THAT(refusal(route), HasSubstr("schema_version = 2"));
}

TEST(Convert, NotFiniteIsRefusedEverywhere) {
  for (const double bad : {kNan, kInf, -kInf}) {
    Mission mission = samples::mission();
    mission.arcs[1].waypoints[2].position_m.z() = bad;
    EXPECT_THAT(refusal(to_wire(mission)), HasSubstr("waypoint.position_m"));
    mission = samples::mission();
    mission.arcs[0].waypoints[0].look.x() = bad;
    EXPECT_THAT(refusal(to_wire(mission)), HasSubstr("waypoint.look"));
    mission = samples::mission();
    mission.fleet[1].home_m.y() = bad;
    EXPECT_THAT(refusal(to_wire(mission)), HasSubstr("fleet.home_m"));
    mission = samples::mission();
    mission.fleet[0].speed_mps = bad;
    EXPECT_THAT(refusal(to_wire(mission)), HasSubstr("fleet.speed_mps"));
    mission = samples::mission();
    mission.auction.discount_per_s = bad;
    EXPECT_THAT(refusal(to_wire(mission)), HasSubstr("discount_per_s"));
    mission = samples::mission();
    mission.auction.split_m = bad;
    EXPECT_THAT(refusal(to_wire(mission)), HasSubstr("split_m"));

    BidMessage bids = samples::bids(1);
    std::get<Claims>(bids.statement.body).bundle[1].bid = bad;
    EXPECT_THAT(refusal(to_wire(bids)), HasSubstr("bundle.bid"));
    RelayMessage relay = samples::relay(1, 2);
    std::get<Table>(relay.statement.body).beliefs[1].bid = bad;
    EXPECT_THAT(refusal(to_wire(relay)), HasSubstr("table.bid"));

    RouteMessage route = samples::route(1);
    route.length_m = bad;
    EXPECT_THAT(refusal(to_wire(route)), HasSubstr("length_m"));
    route = samples::route(1);
    route.time_s = bad;
    EXPECT_THAT(refusal(to_wire(route)), HasSubstr("time_s"));
    route = samples::route(1);
    route.legs[1].from_m = bad;
    EXPECT_THAT(refusal(to_wire(route)), HasSubstr("leg.from_m"));
    route = samples::route(1);
    route.legs[1].to_m = bad;
    EXPECT_THAT(refusal(to_wire(route)), HasSubstr("leg.to_m"));
    route = samples::route(1);
    route.legs[0].waypoints[1].look.z() = bad;
    EXPECT_THAT(refusal(to_wire(route)), HasSubstr("waypoint.look"));
  }
}

TEST(Convert, ValuesOutsideEnumerationsAreRefused) {
  wire::Mission mission = to_wire(samples::mission());
  mission.arcs()[1].kind(static_cast<wire::ArcKind>(4));
  EXPECT_THAT(refusal(mission), HasSubstr("arc.kind = 4"));
  mission = to_wire(samples::mission());
  mission.auction().policy(static_cast<wire::PolicyKind>(5));
  EXPECT_THAT(refusal(mission), HasSubstr("auction.policy = 5"));
  mission = to_wire(samples::mission());
  mission.auction().score(static_cast<wire::ScoreKind>(0xffffffff));
  EXPECT_THAT(refusal(mission), HasSubstr("auction.score = 4294967295"));
  mission = to_wire(samples::mission());
  mission.tour().solver(static_cast<wire::TourSolver>(2));
  EXPECT_THAT(refusal(mission), HasSubstr("tour.solver = 2"));
  wire::Control control = to_wire(samples::control());
  control.command(static_cast<wire::Command>(2));
  EXPECT_THAT(refusal(control), HasSubstr("command = 2"));
  wire::Status status = to_wire(samples::status(1));
  status.phase(static_cast<wire::Phase>(5));
  EXPECT_THAT(refusal(status), HasSubstr("phase = 5"));
}

TEST(Convert, MissionsNobodyCanFlyAreRefused) {
  const auto refused_after = [](auto change) {
    Mission mission = samples::mission();
    change(mission);
    return refusal(to_wire(mission));
  };
  EXPECT_THAT(refused_after([](Mission& m) { m.arcs.clear(); }), HasSubstr("arcs.size = 0"));
  EXPECT_THAT(refused_after([](Mission& m) { m.fleet.clear(); }), HasSubstr("fleet.size = 0"));
  EXPECT_THAT(refused_after([](Mission& m) { m.arcs[0].waypoints.resize(1); }),
              HasSubstr("arc.waypoints.size = 1"));
  EXPECT_THAT(refused_after([](Mission& m) { m.arcs[0].waypoints[1] = m.arcs[0].waypoints[0]; }),
              HasSubstr("repeated position at = 1"));
  EXPECT_THAT(refused_after([](Mission& m) { m.fleet[1].id = AgentId{1}; }), HasSubstr("fleet.id"));
  EXPECT_THAT(refused_after([](Mission& m) { m.fleet[0].id = AgentId{0}; }), HasSubstr("fleet.id"));
  EXPECT_THAT(refused_after([](Mission& m) { m.fleet[0].speed_mps = 0; }), HasSubstr("speed_mps"));
  EXPECT_THAT(refused_after([](Mission& m) { m.auction.split_m = 0; }), HasSubstr("split_m"));
  EXPECT_THAT(refused_after([](Mission& m) { m.auction.max_tasks = 0; }), HasSubstr("max_tasks"));
  EXPECT_THAT(refused_after([](Mission& m) { m.auction.tick_ns = 0; }), HasSubstr("tick_ns"));
  EXPECT_THAT(refused_after([](Mission& m) { m.auction.lease_ns = 0; }), HasSubstr("lease_ns"));
  EXPECT_THAT(refused_after([](Mission& m) { m.auction.barrier_ns = -1; }),
              HasSubstr("barrier_ns"));
  EXPECT_THAT(refused_after([](Mission& m) { m.name.assign(kMaxText + 1, 'x'); }),
              HasSubstr("name has 4097 entries"));
}

TEST(Convert, AirspacesThatNoCoordinatorMakesAreRefused) {
  const auto refused_after = [](auto change) {
    Mission mission = samples::mission();
    change(mission.airspace);
    return refusal(to_wire(mission));
  };
  EXPECT_EQ(refused_after([](Airspace&) {}), "accepted");
  EXPECT_EQ(refused_after([](Airspace& a) { a = {}; }), "accepted");
  for (const double bad : {kNan, kInf, -kInf}) {
    EXPECT_THAT(refused_after([&](Airspace& a) { a.low_m.y() = bad; }),
                HasSubstr("airspace.low_m"));
    EXPECT_THAT(refused_after([&](Airspace& a) { a.cell_m = bad; }), HasSubstr("airspace.cell_m"));
    EXPECT_THAT(refused_after([&](Airspace& a) { a.accesses[0].points[1].position_m.x() = bad; }),
                HasSubstr("airspace.access.points"));
  }
  EXPECT_THAT(refused_after([](Airspace& a) {
                a.cells = {4'000'000'000, 2, 3};
              }),
              HasSubstr("cells: 4000000000 along an axis"));
  EXPECT_THAT(refused_after([](Airspace& a) {
                a.cells = {4, 3, 1};
              }),
              HasSubstr("more than the 12"));
  EXPECT_THAT(refused_after([](Airspace& a) { a.runs = {255, 255, 255, 255, 255, 1}; }),
              HasSubstr("runs: no number at byte 0"));
  EXPECT_THAT(refused_after([](Airspace& a) { a.runs.clear(); }), HasSubstr("0 cells instead of"));
  EXPECT_THAT(refused_after([](Airspace& a) { a.accesses[0].arc.value = 1000; }),
              HasSubstr("airspace.access.arc = 1000"));
  EXPECT_THAT(refused_after([](Airspace& a) { a.accesses[0].waypoint = 0; }),
              HasSubstr("airspace.access.waypoint = 0"));
  EXPECT_THAT(refused_after([](Airspace& a) { a.accesses[0].points.clear(); }),
              HasSubstr("airspace.access.waypoint"));
  EXPECT_THAT(refused_after([](Airspace& a) { a.accesses[0].points.resize(1); }),
              HasSubstr("fewer than two points"));
}

TEST(Convert, OversizedAndNamelessAreRefused) {
  EXPECT_THAT(refusal(to_wire(samples::bids(0))), HasSubstr("sender = 0"));
  EXPECT_THAT(refusal(to_wire(samples::relay(1, 0))), HasSubstr("origin = 0"));
  BidMessage bids = samples::bids(1);
  std::get<Claims>(bids.statement.body).bundle.resize(kMaxArcs + 1);
  EXPECT_THAT(refusal(to_wire(bids)), HasSubstr("bundle has 200001"));
  StatusMessage status = samples::status(1);
  status.ready.resize(kMaxAgents + 1);
  EXPECT_THAT(refusal(to_wire(status)), HasSubstr("ready has 1025"));
  RouteMessage route = samples::route(1);
  route.legs.resize(kMaxArcs + 1);
  EXPECT_THAT(refusal(to_wire(route)), HasSubstr("legs has 200001"));
}

/// Bytes of a valid payload with some changed, cut or appended: never an exception, and whatever
/// the decoder can't read is refused with a reason.
template <class Message>
void fuzz(const Message& message, std::mt19937_64& random) {
  GuardedType<typename Topic<Message>::Type> type;
  auto sample = to_wire(message);
  eprosima::fastrtps::rtps::SerializedPayload_t good(type.getSerializedSizeProvider(&sample)());
  ASSERT_TRUE(type.serialize(&sample, &good));
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    eprosima::fastrtps::rtps::SerializedPayload_t bad(good.length);
    bad.copy(&good);
    for (std::uint64_t k = random() % 4 + 1; k > 0; --k)
      bad.data[random() % bad.length] = static_cast<std::uint8_t>(random());
    if (random() % 3 == 0) bad.length = static_cast<std::uint32_t>(random() % (good.length + 1));
    decltype(sample) decoded;
    eprosima::fastrtps::rtps::InstanceHandle_t key;
    ASSERT_TRUE(type.deserialize(&bad, &decoded));
    type.getKey(&decoded, &key, false);
    refused += std::holds_alternative<std::string>(from_wire(decoded));
  }
  EXPECT_GT(refused, 600);
}

TEST(Convert, MutatedPayloadsNeverThrow) {
  std::mt19937_64 random(1);
  fuzz(samples::mission(), random);
  fuzz(samples::control(), random);
  fuzz(samples::bids(1), random);
  fuzz(samples::relay(1, 2), random);
  fuzz(samples::status(1), random);
  fuzz(samples::route(1), random);
}

TEST(Convert, UndecodablePayloadSaysSo) {
  GuardedType<wire::BidsPubSubType> type;
  eprosima::fastrtps::rtps::SerializedPayload_t payload(3);
  payload.length = 3;
  wire::Bids sample = to_wire(samples::bids(1));
  EXPECT_TRUE(type.deserialize(&payload, &sample));
  EXPECT_EQ(refusal(sample), "payload cannot be decoded");
}

}  // namespace
}  // namespace arcbid
