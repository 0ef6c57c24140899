// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "core/structure/bridge_arcs.hpp"
#include "tests/structure/arc_laws.hpp"

namespace arcbid {
namespace {

/// Up to six boxes, turned, apart or through each other, now and then flat.
Structure random_boxes(boost::random::mt19937_64& random) {
  const auto real = [&](double low, double high) {
    return boost::random::uniform_real_distribution<double>(low, high)(random);
  };
  Structure all;
  for (int n = boost::random::uniform_int_distribution<int>(1, 6)(random); n > 0; --n) {
    const Vec3 low(real(-30, 20), real(-30, 20), real(0, 15));
    const double height = real(0, 1) < 0.2 ? 0 : real(0.2, 25);
    all = joined(all, box_mesh(low, low + Vec3(real(0.1, 30), real(0.1, 10), height), real(0, 3)));
  }
  return all;
}

class RandomBoxes : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomBoxes, KeepTheLaws) {
  boost::random::mt19937_64 random(GetParam());
  const Structure boxes = random_boxes(random);
  CoverageSettings settings;
  settings.spacing_m = boost::random::uniform_real_distribution<double>(2, 7)(random);
  settings.standoff_m = boost::random::uniform_real_distribution<double>(2.3, 6)(random);
  settings.rows = GetParam() % 2 == 0 ? RowSide::short_side : RowSide::long_side;
  const ArcPlan plan = bridge_arcs(boxes, settings);
  expect_arc_laws(plan, boxes, settings);
  EXPECT_EQ(digest(plan.arcs), digest(bridge_arcs(boxes, settings).arcs));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBoxes, testing::Range<std::uint64_t>(1, 41));

}  // namespace
}  // namespace arcbid
