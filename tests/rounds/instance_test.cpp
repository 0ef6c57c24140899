// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/instance.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.hpp"
#include "sim/auction/difference.hpp"
#include "sim/auction/rounds.hpp"

namespace arcbid::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* good_agents = "agent,x,y,z,speed\n0,1,2,3,10\n1,4,5,6,12.5\n";
constexpr const char* good_tasks =
    "task,x,y,z,value_unit,value_weighted\n0,7,8,9,1,0.5\n1,1e1,-2,0,1,2\n";

class InstanceFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("arcbid-instance-" + std::to_string(::getpid()) + "-" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Instance read(const std::string& agents, const std::string& tasks,
                const std::string& values = "value_unit") {
    std::ofstream(folder_ / "a.csv") << agents;
    std::ofstream(folder_ / "t.csv") << tasks;
    return read_instance(folder_ / "a.csv", folder_ / "t.csv", values);
  }
  std::string problem(const std::string& agents, const std::string& tasks) {
    try {
      read(agents, tasks);
    } catch (const InputError& error) {
      std::string line = error.what();
      const std::size_t at = line.find(folder_.string() + "/");
      return at == 0 ? line.substr(folder_.string().size() + 1) : line;
    }
    return "accepted";
  }
  fs::path folder_;
};

TEST_F(InstanceFiles, AreReadExactly) {
  const Instance instance = read(good_agents, good_tasks, "value_weighted");
  ASSERT_EQ(instance.fleet.size(), 2u);
  EXPECT_EQ(instance.fleet[1].id, AgentId{2});
  EXPECT_EQ(instance.fleet[1].home_m, Vec3(4, 5, 6));
  EXPECT_EQ(instance.fleet[1].speed_mps, 12.5);
  ASSERT_EQ(instance.tasks.tasks.size(), 2u);
  EXPECT_EQ(instance.tasks.tasks[1].first_m, Vec3(10, -2, 0));
  EXPECT_EQ(instance.tasks.tasks[1].value, 2);
  EXPECT_FALSE(instance.tasks.return_home);
}

TEST_F(InstanceFiles, SayWhatIsWrongWhere) {
  const auto agents = [](const std::string& row) { return "agent,x,y,z,speed\n" + row + "\n"; };
  EXPECT_EQ(problem(agents("0,abc,2,3,10"), good_tasks),
            "a.csv:2: x: 'abc' is not a finite number");
  EXPECT_EQ(problem(agents("0,nan,2,3,10"), good_tasks),
            "a.csv:2: x: 'nan' is not a finite number");
  EXPECT_EQ(problem(agents("1,1,2,3,10"), good_tasks),
            "a.csv:2: agent: '1' is not 0, the next number");
  EXPECT_EQ(problem(agents("0,1,2,3,0"), good_tasks), "a.csv: speed of agent 0: 0 is not above 0");
  EXPECT_EQ(problem("agent,x,y,z,speed\n", good_tasks), "a.csv: no rows below the header");
  EXPECT_NE(problem("agent,x,y,speed\n0,1,2,10\n", good_tasks).find("z"), std::string::npos);
  EXPECT_NE(problem(agents("0,1,2"), good_tasks).find("a.csv"), std::string::npos);
}

TEST(Graphs, HaveTheirNeighboursAndDiameters) {
  using N = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(neighbours(Graph::line, 3), (N{{1}, {0, 2}, {1}}));
  EXPECT_EQ(neighbours(Graph::ring, 4), (N{{1, 3}, {0, 2}, {1, 3}, {0, 2}}));
  EXPECT_EQ(neighbours(Graph::ring, 2), (N{{1}, {0}}));
  EXPECT_EQ(neighbours(Graph::star, 3), (N{{1, 2}, {0}, {0}}));
  EXPECT_EQ(neighbours(Graph::complete, 3), (N{{1, 2}, {0, 2}, {0, 1}}));
  EXPECT_EQ(diameter(Graph::line, 5), 4u);
  EXPECT_EQ(diameter(Graph::ring, 5), 2u);
  EXPECT_EQ(diameter(Graph::star, 5), 2u);
  EXPECT_EQ(diameter(Graph::complete, 5), 1u);
  EXPECT_EQ(diameter(Graph::complete, 1), 0u);
}

TEST(Differences, RestoreTheBundleAndNameWhatWasThere) {
  const Claim a{{1}, 5}, b{{2}, 4}, c{{3}, 3}, other_b{{2}, 3.5};
  const auto through = [](const std::vector<Claim>& before, const std::vector<Claim>& now) {
    const Difference what = difference(before, now);
    EXPECT_EQ(restored(what, before), now);
    return what.bytes();
  };
  EXPECT_EQ(through({}, {a, b}), 22u);           // two claims
  EXPECT_EQ(through({a, b, c}, {a, b, c}), 2u);  // nothing new
  EXPECT_EQ(through({a, b, c}, {a, c}), 4u);     // c is named by its place
  EXPECT_EQ(through({a, b, c}, {a, other_b, c}), 14u);
  EXPECT_EQ(through({a, b}, {}), 2u);
}

}  // namespace
}  // namespace arcbid::testing
