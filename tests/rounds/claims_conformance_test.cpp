// SPDX-License-Identifier: GPL-3.0-or-later
// Claims on the same instances: with rebuild they end where CBBA with rebuild ends, which is the
// sequential greedy allocation, on every graph; keeping, they are worth what published CBBA is
// worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "sim/auction/evaluate.hpp"
#include "tests/rounds/references.hpp"

namespace arcbid::testing {
namespace {

class ClaimsConformance : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!references_exist())
      GTEST_SKIP() << references_folder() << " (third-party data) is not here";
  }
};

TEST_P(ClaimsConformance, RebuildIsSequentialGreedyOnEveryGraph) {
  const auto all = references("ref_rebuild", GetParam());
  ASSERT_GT(all.size(), 20U);
  for (const Reference& r : all) {
    SCOPED_TRACE(r.label);
    AuctionSettings settings = r.settings;
    settings.policy = PolicyKind::claims;
    const RoundsOutcome ours = run_rounds(r.instance, settings, r.graph);
    EXPECT_TRUE(ours.converged && ours.agreed);
    EXPECT_GT(ours.proof_round, 0u);
    EXPECT_EQ(to_json(ours.paths), r.result["cbba_paths"]);
    EXPECT_EQ(to_json(ours.paths), r.result["sga_paths"]);
  }
}

TEST_P(ClaimsConformance, KeepingIsWorthWhatPublishedCbbaIs) {
  for (const Reference& r : references("ref_published", GetParam())) {
    SCOPED_TRACE(r.label);
    AuctionSettings settings = r.settings;
    settings.policy = PolicyKind::claims_keep;
    const RoundsOutcome ours = run_rounds(r.instance, settings, r.graph);
    EXPECT_TRUE(ours.converged && ours.agreed);
    const Evaluation value = evaluate(r.instance, ours.paths, settings.discount_per_s);
    EXPECT_EQ(value.conflicts, 0u);
    EXPECT_EQ(value.assigned, r.instance.tasks.tasks.size());
    if (GetParam() != "TDA") continue;  // bids are not rewards
    // On sparse graphs the two hear of things in another order, and may keep other tasks.
    const double tolerance = r.graph == Graph::complete ? 1e-9 : 0.01 * value.score;
    EXPECT_NEAR(value.score, r.result["score"].get<double>(), tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ClaimsConformance, ::testing::Values("MOD", "TDA", "TDW", "RPT"),
                         [](const auto& family) { return family.param; });

/// Column `opt_tdr` of exact.csv by instance.
std::map<std::string, double> exact_optima() {
  std::ifstream file(references_folder() + "/exact.csv");
  std::map<std::string, double> optima;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::istringstream row(line);
    std::string name, skip, optimum;
    std::getline(row, name, ',');
    for (int column = 0; column < 3; ++column) std::getline(row, skip, ',');
    std::getline(row, optimum, ',');
    optima[name] = std::stod(optimum);
  }
  return optima;
}

TEST(Optimum, IsNearlyReachedOnTheSmallInstances) {
  if (!references_exist()) GTEST_SKIP() << references_folder() << " (third-party data) is not here";
  const auto optima = exact_optima();
  std::size_t compared = 0;
  for (const Reference& r : references("ref_rebuild", "TDW")) {
    const auto optimum = optima.find(r.result["instance"]);
    if (optimum == optima.end() || r.result["values"] != "unit") continue;
    AuctionSettings settings = r.settings;
    settings.policy = PolicyKind::claims;
    const RoundsOutcome ours = run_rounds(r.instance, settings, r.graph);
    const double ratio =
        evaluate(r.instance, ours.paths, settings.discount_per_s).score / optimum->second;
    RecordProperty(r.label, std::to_string(ratio));
    EXPECT_GE(ratio, 0.95) << r.label;
    EXPECT_LE(ratio, 1 + 1e-9) << r.label;
    ++compared;
  }
  EXPECT_GE(compared, 6u);
}

}  // namespace
}  // namespace arcbid::testing
