// SPDX-License-Identifier: GPL-3.0-or-later
// Statements as orders of tasks: they restore to the last bit, and what is no statement is none.
#include "sim/auction/orders.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/auction/policy.hpp"
#include "sim/auction/rounds.hpp"
#include "tests/rounds/points.hpp"

namespace arcbid::testing {
namespace {

constexpr std::uint32_t tasks = 300;

/// One author of bundles that grow, shrink and change as in an auction, and a reader.
class Orders : public ::testing::TestWithParam<ScoreKind> {
 protected:
  Orders() { settings.score = GetParam(); }

  BundleReplay replay() const {
    return make_replay(instance.tasks, instance.fleet[0], settings, transit);
  }
  /// Keeps a part of the bundle, and takes tasks at random.
  Said next(const Said& before) {
    BundleReplay bundle = replay();
    std::vector<bool> taken(tasks, false);
    const auto take = [&](TaskId task) {
      if (!taken[task.value]) bundle.take(task);
      taken[task.value] = true;
    };
    const std::uint32_t keep = dice() % 4;
    for (const Claim& claim : before.bundle)
      if (dice() % 8 >= keep) take(claim.task);
    for (std::uint32_t n = dice() % 12; n > 0; --n) take({dice() % tasks});
    return {{5, false, before.key.version + 1 + dice() % 200}, bundle.claims()};
  }
  std::uint32_t dice() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(state_ >> 40);
  }

  const Instance instance = random_points(1, 2, tasks);
  const StraightTransit transit;
  AuctionSettings settings;

 private:
  std::uint64_t state_ = 1;
};

TEST_P(Orders, RestoreEveryBundleToTheLastBit) {
  BundleReplay author = replay(), reader = replay();
  Said before;
  for (int step = 0; step < 300; ++step) {
    const Said now = next(before);
    const Bytes bytes = encode(before, now, author);
    const auto read = decode(bytes, before, tasks, reader);
    ASSERT_TRUE(read) << "step " << step;
    ASSERT_EQ(*read, now) << "step " << step;
    before = now;
  }
}

TEST_P(Orders, CarryTheBidsThatDoNotFollow) {
  BundleReplay author = replay(), reader = replay();
  Said now = next({});
  ASSERT_FALSE(now.bundle.empty());
  const std::size_t without = encode({}, now, author).size();
  now.bundle.back().bid *= 1 + 1e-15;
  const Bytes bytes = encode({}, now, author);
  EXPECT_EQ(bytes.size(), without + 8 * now.bundle.size());
  EXPECT_EQ(decode(bytes, {}, tasks, reader), now);
}

INSTANTIATE_TEST_SUITE_P(Of, Orders,
                         ::testing::Values(ScoreKind::minimax, ScoreKind::minisum,
                                           ScoreKind::discounted_append,
                                           ScoreKind::discounted_insert,
                                           ScoreKind::discounted_insert_warped),
                         [](const auto& p) {
                           std::string name(name_of(p.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

using OneOrder = Orders;

TEST_P(OneOrder, CostsAFewBytes) {
  BundleReplay author = replay();
  Said before{{5, false, 7}, {}};
  for (const std::uint32_t task : {100u, 200u, 3u, 150u, 250u, 4u}) author.take({task});
  before.bundle = author.claims();
  author.keep(2);
  for (const std::uint32_t task : {150u, 250u, 4u, 9u}) author.take({task});
  const Said now{{5, false, 8}, author.claims()};
  // One version on, three entries: the first two as before, those from the fourth on, task 9.
  EXPECT_EQ(encode(before, now, author), (Bytes{1, 6, 1, 2, 7, 3, 18}));
}

TEST_P(OneOrder, ThatIsNoneIsRefused) {
  BundleReplay author = replay(), reader = replay();
  const Said before = next({});
  const auto outside = static_cast<std::uint8_t>(2 * (before.bundle.size() + 1) + 1);
  const Bytes hostile[] = {{},                                 // nothing
                           {1},                                // no entries
                           {1, 2},                             // one of which there is nothing
                           {1, 2, 0xd8, 0x04},                 // task 300
                           {1, 4, 2, 2},                       // a task twice
                           {1, 2, outside, 1},                 // a run from beyond the end
                           {1, 2, 1, 127},                     // and beyond it
                           {1, 2, 2, 0},                       // more than was said
                           {1, 3, 2, 0, 0, 0},                 // bids of which half is missing
                           {0xff, 0xff, 0xff, 0xff, 0x7f, 0},  // a version that there cannot be
                           Bytes(20, 0xff),                    // a number without an end
                           {1, 0xfe, 0xff, 0xff, 0xff, 0xff, 0xff, 0x3f}};
  for (const Bytes& bytes : hostile)
    EXPECT_EQ(decode(bytes, before, tasks, reader), std::nullopt)
        << fmt::format("{}", bytes.size());
}

TEST_P(OneOrder, CutShortOrSpoiltNeverDoesHarm) {
  BundleReplay author = replay(), reader = replay();
  const Said before = next({}), now = next(before);
  const Bytes bytes = encode(before, now, author);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(decode(std::span(bytes).first(size), before, tasks, reader), std::nullopt);
  for (int step = 0; step < 2000; ++step) {
    Bytes spoilt = bytes;
    for (int n = 0; n < 3; ++n) spoilt[dice() % spoilt.size()] = static_cast<std::uint8_t>(dice());
    const auto read = decode(spoilt, before, tasks, reader);
    for (const Claim& claim : read ? read->bundle : std::vector<Claim>{})
      EXPECT_LT(claim.task.value, tasks);
  }
  EXPECT_EQ(decode(bytes, before, tasks, reader), now) << "and leaves nothing behind";
}

INSTANTIATE_TEST_SUITE_P(Of, OneOrder, ::testing::Values(ScoreKind::discounted_append));

/// Every statement of these runs is restored and compared as it is sent (rounds_claims.cpp).
TEST(OrderBytes, AreBelowDifferencesWithBids) {
  for (const Graph graph : {Graph::complete, Graph::ring, Graph::line, Graph::star})
    for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::claims_keep}) {
      AuctionSettings settings;
      settings.policy = policy;
      settings.score = ScoreKind::discounted_append;
      settings.bundle_limit = 12;
      const Instance instance = random_points(80100, 8, 60);
      const RoundsOutcome plain = run_rounds(instance, settings, graph);
      const RoundsOutcome orders = run_rounds(instance, settings, graph, Encoding::orders);
      EXPECT_LT(2 * orders.order_bytes, orders.difference_bytes);
      EXPECT_EQ(plain.order_bytes, 0u) << "nobody asked";
      EXPECT_EQ(orders.paths, plain.paths);
      EXPECT_EQ(orders.bytes, plain.bytes);
      EXPECT_EQ(orders.difference_bytes, plain.difference_bytes);
    }
}

TEST(OrderBytes, AreCountedUnderEveryScore) {
  for (std::size_t score = 0; score < score_names.size(); ++score)
    for (const PolicyKind policy : {PolicyKind::claims, PolicyKind::claims_keep}) {
      AuctionSettings settings;
      settings.policy = policy;
      settings.score = static_cast<ScoreKind>(score);
      const Instance instance = random_points(50030, 5, 30);
      const RoundsOutcome outcome = run_rounds(instance, settings, Graph::ring, Encoding::orders);
      EXPECT_LT(outcome.order_bytes, outcome.bytes) << score_names[score];
      EXPECT_GT(outcome.order_bytes, 0u);
    }
}

}  // namespace
}  // namespace arcbid::testing
