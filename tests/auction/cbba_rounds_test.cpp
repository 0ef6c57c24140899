// SPDX-License-Identifier: GPL-3.0-or-later
// Published CBBA: whole fleets in synchronous rounds over fixed graphs, without loss.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/auction/cbba.hpp"
#include "tests/auction/fleet.hpp"

namespace arcbid::testing {
namespace {

enum class Shape { complete, ring, line };

bool linked(Shape shape, std::size_t a, std::size_t b, std::size_t agents) {
  const std::size_t apart = a > b ? a - b : b - a;
  if (shape == Shape::complete) return apart > 0;
  return apart == 1 || (shape == Shape::ring && apart + 1 == agents && agents > 2);
}

std::size_t diameter(Shape shape, std::size_t agents) {
  if (shape == Shape::complete) return 1;
  return shape == Shape::ring ? std::max<std::size_t>(1, agents / 2) : agents - 1;
}

/// A fleet under published CBBA: in every round all agents bid, then all hear their neighbours.
class Rounds {
 public:
  Rounds(Mission mission, Shape shape) : mission_(std::move(mission)), shape_(shape) {
    set_ = split(mission_.arcs, mission_.auction.split_m, 1000);
    std::vector<AgentId> ids;
    for (const Uav& uav : mission_.fleet) ids.push_back(uav.id);
    const std::size_t tasks = set_.tasks.size();
    const std::uint32_t limit = mission_.auction.bundle_limit;
    for (const Uav& uav : mission_.fleet)
      agents_.emplace_back(
          uav.id, ids,
          Bundle(uav.id, make_score(set_, uav, mission_.auction, transit_), tasks, limit), tasks);
  }

  /// Returns whether any agent believes something else than before.
  bool play() {
    ++round_;
    const auto before = beliefs();
    std::vector<Table> said;
    for (CbbaState& agent : agents_) {
      agent.release();
      agent.bid();
      said.push_back(agent.table());
    }
    for (std::size_t i = 0; i < agents_.size(); ++i)
      for (std::size_t k = 0; k < agents_.size(); ++k)
        if (linked(shape_, i, k, agents_.size())) agents_[i].receive(k, said[k], round_);
    return beliefs() != before;
  }

  /// The last round that changed anything, once 2 D + 2 rounds changed nothing.
  std::size_t last_change() {
    std::size_t last = 0, quiet = 0;
    const std::size_t enough = 2 * diameter(shape_, agents_.size()) + 2;
    while (quiet < enough && round_ < 1000) {
      const bool changed = play();
      quiet = changed ? 0 : quiet + 1;
      if (changed) last = round_;
    }
    return last;
  }

  std::vector<std::vector<Belief>> beliefs() const {
    std::vector<std::vector<Belief>> all;
    for (const CbbaState& agent : agents_) all.push_back(agent.table().beliefs);
    return all;
  }
  std::size_t bound() const {
    const std::size_t tasks = set_.tasks.size();
    const std::size_t limit = mission_.auction.bundle_limit;
    const std::size_t n_min = limit ? std::min(tasks, limit * agents_.size()) : tasks;
    return n_min * diameter(shape_, agents_.size());
  }
  const std::vector<CbbaState>& agents() const { return agents_; }
  const TaskSet& set() const { return set_; }

 private:
  Mission mission_;
  Shape shape_;
  StraightTransit transit_;
  TaskSet set_;
  std::vector<CbbaState> agents_;
  std::uint64_t round_ = 0;
};

/// P2 to P4: all agree; every task has an owner, who flies it at the bid that all know.
void expect_sound(const Rounds& fleet, bool complete) {
  const auto& z = fleet.agents().front().table().beliefs;
  std::vector<int> owners(z.size(), 0);
  for (std::size_t i = 0; i < fleet.agents().size(); ++i) {
    const CbbaState& agent = fleet.agents()[i];
    EXPECT_EQ(agent.table().beliefs, z) << "agent " << i << " disagrees";
    const AgentId id{static_cast<std::uint32_t>(i + 1)};
    EXPECT_EQ(agent.bundle().path().size(), agent.bundle().claims().size());
    for (const Claim& claim : agent.bundle().claims()) {
      ++owners[claim.task.value];
      EXPECT_EQ(z[claim.task.value], (Belief{id, claim.bid}));
    }
  }
  for (std::size_t j = 0; j < z.size(); ++j) {
    EXPECT_EQ(owners[j], z[j].winner ? 1 : 0) << "task " << j;
    EXPECT_TRUE(z[j].winner || !complete) << "task " << j;
  }
}

class PublishedCbba : public ::testing::TestWithParam<Shape> {};

std::string name_of(const ::testing::TestParamInfo<Shape>& shape) {
  const char* names[] = {"Complete", "Ring", "Line"};
  return names[int(shape.param)];
}

INSTANTIATE_TEST_SUITE_P(On, PublishedCbba,
                         ::testing::Values(Shape::complete, Shape::ring, Shape::line), name_of);

TEST_P(PublishedCbba, AgreesOnAWholeAllocationWithinItsBound) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto agents = static_cast<std::uint32_t>(2 + seed % 6);
    Rounds fleet(random_mission(seed, agents, static_cast<std::uint32_t>(1 + seed % 9)),
                 GetParam());
    const std::size_t last = fleet.last_change();
    EXPECT_GT(last, 0u);
    EXPECT_LE(last, fleet.bound());
    expect_sound(fleet, true);
    const auto rest = fleet.beliefs();
    for (std::size_t more = 2 * agents + 2; more > 0; --more) fleet.play();
    EXPECT_EQ(fleet.beliefs(), rest) << "rest was not stable";
  }
}

TEST_P(PublishedCbba, AgreesUnderABundleLimit) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mission mission = random_mission(seed, 4, 8);
    mission.auction.bundle_limit = 2;
    Rounds fleet(mission, GetParam());
    EXPECT_LE(fleet.last_change(), fleet.bound());
    expect_sound(fleet, false);
    std::size_t taken = 0;
    for (const CbbaState& agent : fleet.agents()) {
      EXPECT_LE(agent.bundle().claims().size(), 2u);
      taken += agent.bundle().claims().size();
    }
    EXPECT_EQ(taken, std::min<std::size_t>(8, fleet.set().tasks.size()));
  }
}

TEST_P(PublishedCbba, AgreesUnderWarpedBidsWhereGainsDoNotDiminish) {
  for (const ScoreKind kind : {ScoreKind::minisum, ScoreKind::discounted_insert_warped})
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Mission mission = random_mission(seed, 5, 8);
      mission.auction.score = kind;
      Rounds fleet(mission, GetParam());
      ASSERT_LT(fleet.last_change(), 900u) << "it cycles";
      expect_sound(fleet, true);
    }
}

TEST_P(PublishedCbba, AgreesWhereEverythingTies) {
  Mission mission = random_mission(1, 5, 0);
  for (Uav& uav : mission.fleet) uav = {uav.id, Vec3::Zero(), 1.0};  // all start alike
  for (std::uint32_t m = 0; m < 6; ++m) {
    const Vec3 start(10, 0, m % 2);  // and three arcs lie on each other, twice
    mission.arcs.push_back(
        {{m}, ArcKind::outline, {{start, Vec3::UnitZ()}, {start + Vec3(5, 0, 0), Vec3::UnitZ()}}});
  }
  Rounds fleet(mission, GetParam());
  EXPECT_LE(fleet.last_change(), fleet.bound());
  expect_sound(fleet, true);
}

TEST_P(PublishedCbba, RepeatsBitForBit) {
  const auto once = [shape = GetParam()] {
    Rounds fleet(random_mission(8, 5, 9), shape);
    std::vector<std::vector<std::vector<Belief>>> trace;
    for (int round = 0; round < 20; ++round) {
      fleet.play();
      trace.push_back(fleet.beliefs());
    }
    return trace;
  };
  EXPECT_EQ(once(), once());
}

}  // namespace
}  // namespace arcbid::testing
