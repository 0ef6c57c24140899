// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a structure is like, it is planned and the plan's certificate holds, or one line says
// why not. More of them: ARCBID_ROBUST_CASES=500 build/tests/robust_test
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <string>

#include "core/airspace/surroundings.hpp"
#include "core/base/error.hpp"
#include "core/coverage/coverage_arcs.hpp"
#include "sim/certificate/certificate.hpp"
#include "sim/reproduce/one_route.hpp"
#include "tests/robust/chance.hpp"
#include "tests/robust/random_structure.hpp"

namespace arcbid {
namespace {

using certificate::Certificate;
using certificate::Fate;

CoverageSettings random_settings(std::uint32_t seed) {
  Chance chance(seed);
  CoverageSettings s;
  s.spacing_m = chance.real(2.5, 7);
  s.safety_m = chance.real(1, 2.5);
  s.standoff_m = s.safety_m * chance.real(1.2, 2.2);
  s.ground_clearance_m = chance.real(0, 4);
  if (chance.once_in(3)) s.sensor = camera_preset();
  s.trim = !chance.once_in(5);
  s.rows = chance.once_in(2) ? RowSide::short_side : RowSide::long_side;
  s.seed = seed;
  return s;
}

/// The plan as one UAV flies it, from a home high enough to be in nobody's way.
Certificate certified(const Structure& structure, const CoverageSettings& s) {
  ArcPlan plan = coverage_arcs(structure, s);
  const Surroundings surroundings(structure, s);
  for (const Arc& arc : plan.arcs)
    for (const Waypoint& w : arc.waypoints) EXPECT_GE(w.position_m.z(), surroundings.floor_m());
  const Airspace airspace = surroundings.airspace(plan.arcs, plan.warnings);
  const Vec3 home = plan.high_m + 3 * Vec3::Constant(s.standoff_m);
  certificate::Settings how;
  how.sensor = s.sensor;
  how.safety_m = s.safety_m;
  how.ground_clearance_m = s.ground_clearance_m;
  how.spacing_m = 0.4;
  how.mission_seed = s.seed;
  return certificate::certify(structure, reproduce::one_route(plan.arcs, airspace, home), how);
}

void expect_true(const Certificate& c, double safety_m) {
  EXPECT_TRUE(c.keeps_clear()) << c.min_clearance_m() << " of " << safety_m;
  EXPECT_EQ(c.below_floor_m(), 0);
  EXPECT_EQ(std::accumulate(c.fates.begin(), c.fates.end(), std::uint64_t{0}), c.surface_samples);
  EXPECT_EQ(c.fates[static_cast<std::size_t>(Fate::covered)], c.covered_samples);
  EXPECT_EQ(c.fates[static_cast<std::size_t>(Fate::not_assigned)], 0u);
  EXPECT_EQ(c.samples.size(), c.surface_samples);
  EXPECT_GT(c.flown_m, 0);
}

/// What few samples say is chance, and the planner has few on a sliver. Thin members of a sparse
/// cloud have no normals to speak of: what planner and certificate make of them is different.
double least_coverage(const Certificate& c, const Recipe& recipe) {
  if (c.visible_samples < 200 || recipe.make == Make::spots) return 0.4;
  return recipe.cloud ? 0.75 : 0.98;
}

class RandomStructures : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomStructures, ArePlannedAndCertifiedOrRefusedInOneLine) {
  const Recipe recipe = random_recipe(GetParam());
  const CoverageSettings settings = random_settings(GetParam());
  SCOPED_TRACE(testing::PrintToString(recipe));
  try {
    const Certificate c = certified(make(recipe), settings);
    expect_true(c, settings.safety_m);
    EXPECT_GE(c.coverage_of_visible(), least_coverage(c, recipe));
  } catch (const InputError& e) {
    const std::string line = e.what();
    EXPECT_FALSE(line.empty());
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

std::uint32_t cases() {
  const char* asked = std::getenv("ARCBID_ROBUST_CASES");
  return asked ? static_cast<std::uint32_t>(std::strtoul(asked, nullptr, 10)) : 20;
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomStructures, testing::Range(1U, cases() + 1));

}  // namespace
}  // namespace arcbid
