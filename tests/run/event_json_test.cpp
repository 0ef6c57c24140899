// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/event_json.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace arcbid {
namespace {

using nlohmann::json;

TEST(EventJson, KeepsEveryBitOfABid) {
  for (const double bid : {0.1, -1.0 / 3, 1e-300, -std::numeric_limits<double>::denorm_min(),
                           123456789.123456789, std::numeric_limits<double>::max()}) {
    const Statement statement{{3}, {1000, false, 2}, Claims{{{{5}, bid}}}};
    const json back = json::parse(to_json(statement).dump());
    EXPECT_EQ(back["claims"][0][1].get<double>(), bid);
  }
}

TEST(EventJson, SaysNoWinnerAsNull) {
  const Statement statement{
      {3}, {1000, false, 2}, Table{{{std::nullopt, 0}, {AgentId{2}, -5}}, {1, 2}}};
  const json out = to_json(statement);
  EXPECT_TRUE(out["beliefs"][0][0].is_null());
  EXPECT_EQ(out["beliefs"][1][0], 2);
}

TEST(EventJson, NamesEveryKindOfEvent) {
  EXPECT_EQ(kind({0, Tick{}}), "tick");
  EXPECT_EQ(kind({0, BidMessage{}}), "bid");
  EXPECT_EQ(kind({0, RelayMessage{}}), "relay");
  EXPECT_EQ(kind({0, StatusMessage{}}), "status");
  EXPECT_EQ(kind({0, RoutePublished{}}), "route_published");
}

TEST(EventJson, WritesDigestsWholeAsHexadecimal) {
  EXPECT_EQ(hex(0), "0000000000000000");
  EXPECT_EQ(hex(std::numeric_limits<std::uint64_t>::max()), "ffffffffffffffff");
  EXPECT_EQ(to_json(Event{0, RoutePublished{255}})["view_hash"], "00000000000000ff");
}

TEST(EventJson, CarriesAllOfAMission) {
  Mission mission;
  mission.id = 7;
  mission.name = "m";
  mission.fleet = {{{1}, {1, 2, 3}, 4}};
  mission.arcs = {{{0}, ArcKind::top_row, {{{0, 0, 0}, {0, 0, -1}}, {{3, 4, 0}, {0, 0, -1}}}}};
  const json out = to_json(mission);
  EXPECT_EQ(out["fleet"][0]["home_m"], json({1.0, 2.0, 3.0}));
  EXPECT_EQ(out["arcs"][0]["kind"], "top_row");
  EXPECT_EQ(out["arcs"][0]["length_m"], 5.0);
  EXPECT_EQ(out["digest"], hex(digest(mission)));
  EXPECT_TRUE(out["auction"]["split_m"].is_null());
}

}  // namespace
}  // namespace arcbid
