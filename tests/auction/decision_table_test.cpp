// SPDX-License-Identifier: GPL-3.0-or-later
// Table I of CBBA, three times over: each row by name, all situations against a plain chain of ifs,
// and all situations again through CbbaState::receive with real ids, bids and timestamps.
#include "core/auction/decision_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <ostream>

#include "core/auction/cbba.hpp"
#include "tests/auction/scripted_score.hpp"

namespace arcbid {

std::ostream& operator<<(std::ostream& out, Action action) {
  return out << name(action);
}

namespace testing {
namespace {

struct Example {
  int holds;
  Action action;
};

struct NamedRow {
  const char* name;
  int number;
  Who sender, receiver;
  std::vector<Example> examples;
};

class DecisionTableRow : public ::testing::TestWithParam<NamedRow> {};

TEST_P(DecisionTableRow, DecidesAsPublished) {
  const NamedRow& expected = GetParam();
  const Row& found = row(expected.sender, expected.receiver);
  EXPECT_EQ(found.number, expected.number);
  for (const Example& example : expected.examples)
    EXPECT_EQ(decide(found, static_cast<std::uint8_t>(example.holds)), example.action)
        << "conditions " << example.holds;
}

constexpr Action leave = Action::leave, update = Action::update, reset = Action::reset;
constexpr int newer = newer_m | newer_or_same_m, same = newer_or_same_m, older = older_m;

INSTANTIATE_TEST_SUITE_P(
    TableI, DecisionTableRow,
    ::testing::Values(
        NamedRow{"Row01_SenderClaims_ReceiverClaims",
                 1,
                 Who::k,
                 Who::i,
                 {{0, leave}, {newer, leave}, {higher_bid, update}}},
        NamedRow{"Row02_SenderClaims_ReceiverCreditsSender",
                 2,
                 Who::k,
                 Who::k,
                 {{0, update}, {higher_bid, update}}},
        NamedRow{"Row03_SenderClaims_ReceiverCreditsOther",
                 3,
                 Who::k,
                 Who::m,
                 {{older, leave}, {same, leave}, {newer, update}, {older | higher_bid, update}}},
        NamedRow{"Row04_SenderClaims_ReceiverKnowsNone",
                 4,
                 Who::k,
                 Who::none,
                 {{0, update}, {higher_bid, update}}},
        NamedRow{"Row05_SenderCreditsReceiver_ReceiverClaims",
                 5,
                 Who::i,
                 Who::i,
                 {{0, leave}, {higher_bid, leave}}},
        NamedRow{"Row06_SenderCreditsReceiver_ReceiverCreditsSender",
                 6,
                 Who::i,
                 Who::k,
                 {{0, reset}, {higher_bid, reset}}},
        NamedRow{"Row07_SenderCreditsReceiver_ReceiverCreditsOther",
                 7,
                 Who::i,
                 Who::m,
                 {{older, leave}, {same | higher_bid, leave}, {newer, reset}}},
        NamedRow{"Row08_SenderCreditsReceiver_ReceiverKnowsNone",
                 8,
                 Who::i,
                 Who::none,
                 {{0, leave}, {newer | higher_bid, leave}}},
        NamedRow{"Row09_SenderCreditsOther_ReceiverClaims",
                 9,
                 Who::m,
                 Who::i,
                 {{newer, leave},
                  {higher_bid, leave},
                  {same | higher_bid, leave},
                  {newer | higher_bid, update}}},
        NamedRow{"Row10_SenderCreditsOther_ReceiverCreditsSender",
                 10,
                 Who::m,
                 Who::k,
                 {{older, reset}, {same | higher_bid, reset}, {newer, update}}},
        NamedRow{"Row11_SenderCreditsOther_ReceiverCreditsSameOther",
                 11,
                 Who::m,
                 Who::m,
                 {{older | higher_bid, leave}, {same | higher_bid, leave}, {newer, update}}},
        NamedRow{"Row12_SenderCreditsOther_ReceiverCreditsAnother",
                 12,
                 Who::m,
                 Who::n,
                 {{newer | newer_n, update},
                  {same | newer_n, update},
                  {newer | higher_bid, update},
                  {newer, leave},
                  {same | higher_bid, leave},
                  {older | newer_n, reset},
                  {older | newer_n | higher_bid, reset},
                  {older | higher_bid, leave}}},
        NamedRow{"Row13_SenderCreditsOther_ReceiverKnowsNone",
                 13,
                 Who::m,
                 Who::none,
                 {{older | higher_bid, leave}, {same | higher_bid, leave}, {newer, update}}},
        NamedRow{"Row14_SenderKnowsNone_ReceiverClaims",
                 14,
                 Who::none,
                 Who::i,
                 {{0, leave}, {newer, leave}}},
        NamedRow{
            "Row15_SenderKnowsNone_ReceiverCreditsSender", 15, Who::none, Who::k, {{0, update}}},
        NamedRow{"Row16_SenderKnowsNone_ReceiverCreditsOther",
                 16,
                 Who::none,
                 Who::m,
                 {{older, leave}, {same, leave}, {newer, update}}},
        NamedRow{"Row17_SenderKnowsNone_ReceiverKnowsNone",
                 17,
                 Who::none,
                 Who::none,
                 {{0, leave}, {newer, leave}}}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// One task, as receiver i sees it when it hears from sender k. For a lone other agent (rows 3, 7,
/// 16) `news_of_m` is about that one.
struct Situation {
  Who sends, has;
  int news_of_m;     ///< sign of s_km - s_im
  int news_of_n;     ///< sign of s_kn - s_in
  int bid;           ///< sign of y_kj - y_ij
  bool id_is_lower;  ///< z_kj < z_ij
};

/// The published table, written out a second time without looking at the first; row 12 has MIT's
/// >=.
Action oracle(const Situation& s) {
  const bool newer_of_m = s.news_of_m > 0;
  const bool better = s.bid > 0 || (s.bid == 0 && s.id_is_lower);
  if (s.sends == Who::k) {
    if (s.has == Who::i) return better ? update : leave;
    if (s.has == Who::m) return newer_of_m || better ? update : leave;
    return update;
  }
  if (s.sends == Who::i) {
    if (s.has == Who::k) return reset;
    if (s.has == Who::m && newer_of_m) return reset;
    return leave;
  }
  if (s.sends == Who::none) {
    if (s.has == Who::k) return update;
    if (s.has == Who::m && newer_of_m) return update;
    return leave;
  }
  if (s.has == Who::i) return newer_of_m && better ? update : leave;
  if (s.has == Who::k) return newer_of_m ? update : reset;
  if (s.has == Who::n) {
    if (s.news_of_m >= 0 && s.news_of_n > 0) return update;
    if (newer_of_m && better) return update;
    if (s.news_of_n > 0 && s.news_of_m < 0) return reset;
    return leave;
  }
  return newer_of_m ? update : leave;
}

template <class Body>
void for_all_situations(Body body) {
  for (const Who sends : {Who::i, Who::k, Who::m, Who::none})
    for (const Who has : {Who::i, Who::k, Who::m, Who::n, Who::none}) {
      if (has == Who::n && sends != Who::m) continue;  // a lone other agent is m
      for (const int news_of_m : {-1, 0, 1})
        for (const int news_of_n : {-1, 0, 1})
          for (const int bid : {-1, 0, 1})
            body(Situation{sends, has, news_of_m, news_of_n, bid, false});
    }
}

std::string text(const Situation& s) {
  const char* names[] = {"i", "k", "m", "n", "none"};
  return std::string("z_kj ") + names[int(s.sends)] + ", z_ij " + names[int(s.has)] +
         ", news of m " + std::to_string(s.news_of_m) + ", of n " + std::to_string(s.news_of_n) +
         ", bid " + std::to_string(s.bid) + (s.id_is_lower ? ", lower id" : ", higher id");
}

TEST(DecisionTable, HasOneRowForEveryLegalPair) {
  std::map<std::pair<Who, Who>, int> rows;
  for (const Row& r : decision_table) ++rows[{r.sender, r.receiver}];
  EXPECT_EQ(rows.size(), 17u);
  for (const auto& [pair, count] : rows) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(row(pair.first, pair.second).sender, pair.first);
  }
}

TEST(DecisionTable, EqualsThePublishedOneInEverySituation) {
  int count = 0;
  for_all_situations([&](Situation s) {
    for (const bool lower : {false, true}) {
      s.id_is_lower = lower;
      int holds = always;
      if (s.news_of_m > 0) holds |= newer_m;
      if (s.news_of_m >= 0) holds |= newer_or_same_m;
      if (s.news_of_m < 0) holds |= older_m;
      if (s.news_of_n > 0) holds |= newer_n;
      if (s.bid > 0 || (s.bid == 0 && lower)) holds |= higher_bid;
      EXPECT_EQ(decide(row(s.sends, s.has), static_cast<std::uint8_t>(holds)), oracle(s))
          << text(s);
      ++count;
    }
  });
  EXPECT_EQ(count, 17 * 27 * 2);
}

constexpr double our_bid = 10;
constexpr std::uint64_t our_news = 5;  // s_im and s_in
using Cast = std::array<AgentId, 4>;   // who plays i, k, m, n

Belief belief(Who who, const Cast& cast, double bid) {
  if (who == Who::none) return {};
  return {cast[static_cast<std::size_t>(who)], bid};
}

Table table_of(const Belief& belief, const Cast& cast, std::uint64_t of_m, std::uint64_t of_n) {
  Table table{{belief}, std::vector<std::uint64_t>(4, 0)};
  table.timestamps[cast[2].value - 1] = of_m;
  table.timestamps[cast[3].value - 1] = of_n;
  return table;
}

/// Receiver i as it has come to believe in `has`, with news of m and n as of `our_news`.
CbbaState receiver(Who has, const Cast& cast) {
  auto score = std::make_unique<ScriptedScore>([](TaskId, const auto&) { return our_bid; });
  CbbaState state(cast[0], {{1}, {2}, {3}, {4}}, Bundle(cast[0], std::move(score), 1, 0), 1);
  if (has == Who::i) state.bid();
  const Belief heard = has == Who::i ? Belief{} : belief(has, cast, our_bid);
  state.receive(cast[1].value - 1, table_of(heard, cast, our_news, our_news), our_news);
  return state;
}

Belief expected_belief(Action action, const Belief& ours, const Belief& theirs) {
  if (action == update) return theirs;
  return action == reset ? Belief{} : ours;
}

TEST(DecisionTable, ActsOnRealMessagesInEverySituationAndForEveryOrderOfIds) {
  Cast cast{{{1}, {2}, {3}, {4}}};
  int casts = 0;
  do {
    ++casts;
    for_all_situations([&](Situation s) {
      CbbaState state = receiver(s.has, cast);
      const Belief ours = state.table().beliefs[0];
      ASSERT_EQ(ours, belief(s.has, cast, our_bid)) << "the scene is not set: " << text(s);
      const Belief theirs = belief(s.sends, cast, our_bid + s.bid);
      s.id_is_lower = ours.winner && theirs.winner && *theirs.winner < *ours.winner;
      const auto at = [](int news) { return static_cast<std::uint64_t>(int(our_news) + news); };
      state.receive(cast[1].value - 1, table_of(theirs, cast, at(s.news_of_m), at(s.news_of_n)), 9);
      EXPECT_EQ(state.table().beliefs[0], expected_belief(oracle(s), ours, theirs)) << text(s);
    });
  } while (std::next_permutation(cast.begin(), cast.end()));
  EXPECT_EQ(casts, 24);
}

TEST(DecisionTable, GivesATieToTheLowerWinner) {
  const auto contest = [](Cast cast) {
    CbbaState state = receiver(Who::i, cast);
    state.receive(cast[1].value - 1, table_of({cast[1], our_bid}, cast, 0, 0), 9);
    return *state.table().beliefs[0].winner;
  };
  EXPECT_EQ(contest({{{2}, {1}, {3}, {4}}}), AgentId{1});
  EXPECT_EQ(contest({{{1}, {2}, {3}, {4}}}), AgentId{1});
}

TEST(DecisionTable, TellsBidsApartThatDifferInTheLastBit) {
  const Cast cast{{{1}, {2}, {3}, {4}}};
  CbbaState state = receiver(Who::i, cast);
  state.receive(1, table_of({AgentId{2}, std::nextafter(our_bid, 11)}, cast, 0, 0), 9);
  EXPECT_EQ(state.table().beliefs[0].winner, AgentId{2});
}

TEST(DecisionTable, AppliesEveryTaskBeforeTheTimestampsOfTheSender) {
  // Were s_i brought up to date in between, the second task would look like old news.
  auto score = std::make_unique<ScriptedScore>([](TaskId, const auto&) { return our_bid; });
  CbbaState state({1}, {{1}, {2}, {3}}, Bundle({1}, std::move(score), 2, 0), 2);
  state.receive(1, {{{AgentId{3}, 4.0}, {AgentId{3}, 6.0}}, {0, 0, 7}}, 1);
  EXPECT_EQ(state.table().beliefs, (std::vector<Belief>{{AgentId{3}, 4.0}, {AgentId{3}, 6.0}}));
}

}  // namespace
}  // namespace testing
}  // namespace arcbid
