// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "core/tour/tour.hpp"
#include "tests/tour/random_arcs.hpp"

namespace arcbid {
namespace {

void plan_random_arcs(benchmark::State& state) {
  const auto arcs = random_arcs(static_cast<std::size_t>(state.range(0)), 1);
  const TourSettings settings{.seed = 1, .epochs = static_cast<std::uint32_t>(state.range(1))};
  for (auto _ : state)
    benchmark::DoNotOptimize(plan_tour(arcs, Vec3::Zero(), StraightTransit(), settings));
}
BENCHMARK(plan_random_arcs)
    ->ArgNames({"arcs", "epochs"})
    ->ArgsProduct({{24, 100, 221, 1000}, {30, 100}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace arcbid
