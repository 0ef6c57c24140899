// SPDX-License-Identifier: GPL-3.0-or-later
// Tours by CPU time, one thread: the instances of the paper's Table 2 with cities paired by
// minimum-weight matching, each the mean of 20 seeds, and larger ones made here.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <string>

#include "core/io/process/process.hpp"
#include "sim/tour/solve.hpp"
#include "tests/tour/tsplib.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t kSeeds = 20;

struct PaperRow {
  const char* set;
  double seconds, ratio;
};
constexpr std::array<PaperRow, 9> paper{{{"att48", 0.253, 0.058000},
                                         {"eil101", 0.439, 0.056214},
                                         {"ch150", 1.072, 0.046320},
                                         {"d198", 1.468, 0.061089},
                                         {"rand200", 2.031, 0.043950},
                                         {"gil262", 2.438, 0.070638},
                                         {"a280", 1.911, 0.118066},
                                         {"lin318", 3.203, 0.055971},
                                         {"pcb442", 6.589, 0.110984}}};

SolvedTour solved(const std::vector<TourArc>& arcs, TourSolver solver, std::uint64_t seed,
                  double deadline_s) {
  const StraightTransit straight;
  return solve_tour(arcs, arcs.front().first_m, straight, {.solver = solver, .seed = seed},
                    {deadline_s, {}, thread_cpu_s});
}

struct Mean {
  double gap = 0, worst = 0, seconds = 0;
};

Mean mean_of_seeds(const PairedInstance& instance, TourSolver solver, double deadline_s) {
  Mean out;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const SolvedTour one = solved(instance.arcs, solver, seed, deadline_s);
    const double gap = one.tour.total_m / instance.best_tour_m - 1;
    out.gap += gap / kSeeds;
    out.seconds += one.seconds / kSeeds;
    out.worst = std::max(out.worst, gap);
  }
  return out;
}

void bench_paper(const std::string& pairing) {
  fmt::print(
      "{} pairs: gap to the best tour known, %, mean of {} seeds (worst)\n"
      "{:<9}{:>5}{:>8}{:>9}{:>9}{:>9}{:>16}{:>16}{:>16}\n",
      pairing, kSeeds, "set", "arcs", "crsom", "s", "paper", "its s", "+ls 5 ms", "20 ms",
      "100 ms");
  for (const PaperRow& row : paper) {
    const PairedInstance instance =
        load_instance(std::string(ARCBID_SHARED_DATA) + "/tsplib", row.set, pairing);
    if (instance.arcs.empty()) {
      fmt::print("{:<9}no data\n", row.set);
      continue;
    }
    const Mean ring = mean_of_seeds(instance, TourSolver::crsom, 0.009 * row.seconds);
    fmt::print("{:<9}{:>5}{:>8.2f}{:>9.4f}{:>9.2f}{:>9.3f}", row.set, instance.arcs.size(),
               100 * ring.gap, ring.seconds, 100 * row.ratio, row.seconds);
    for (const double deadline_s : {0.005, 0.02, 0.1}) {
      const Mean search = mean_of_seeds(instance, TourSolver::crsom_ls, deadline_s);
      fmt::print("{:>8.3f} ({:.2f})", 100 * search.gap, 100 * search.worst);
    }
    fmt::print("\n");
  }
}

/// Arcs of 10 m in a square of 1 km, even or in clusters 20 m wide.
std::vector<TourArc> scattered(std::size_t count, bool in_clusters) {
  boost::random::mt19937_64 random(count);
  boost::random::uniform_real_distribution<double> place(0, 1000), off(-20, 20), turn(-1, 1);
  std::vector<Vec3> centres;
  for (std::size_t n = 0; n < std::max<std::size_t>(3, count / 40); ++n) {
    const double x = place(random), y = place(random);
    centres.emplace_back(x, y, 0);
  }
  std::vector<TourArc> arcs;
  for (std::size_t n = 0; n < count; ++n) {
    const double x = in_clusters ? off(random) : place(random);
    const double y = in_clusters ? off(random) : place(random);
    const Vec3 first = Vec3(x, y, 0) + (in_clusters ? centres[n % centres.size()] : Vec3(0, 0, 0));
    const double east = turn(random), north = turn(random);
    arcs.push_back({first, first + 10 * Vec3(east, north, 0).normalized(), 10});
  }
  return arcs;
}

/// Nobody knows these optima: the reference is the same search, for a minute.
void bench_larger() {
  fmt::print("larger: gap to the same search after 60 s, %, seed 1\n{:<20}{:>9}{:>9}{:>9}\n", "",
             "100 ms", "300 ms", "1 s");
  for (const std::size_t count : {600, 1200, 5000})
    for (const bool in_clusters : {false, true}) {
      const std::vector<TourArc> arcs = scattered(count, in_clusters);
      const double best = solved(arcs, TourSolver::crsom_ls, 7, 60).tour.total_m;
      fmt::print("{:<20}", fmt::format("{} {}", count, in_clusters ? "in clusters" : "even"));
      for (const double deadline_s : {0.1, 0.3, 1.0}) {
        const double found = solved(arcs, TourSolver::crsom_ls, 1, deadline_s).tour.total_m;
        fmt::print("{:>9.2f}", 100 * (found / best - 1));
      }
      fmt::print("\n");
    }
}

}  // namespace
}  // namespace arcbid

/// With an argument only the part so named: matching, consecutive, larger.
int main(int argc, char** argv) {
  const std::string part = argc > 1 ? argv[1] : "";
  for (const char* pairing : {"matching", "consecutive"})
    if (part.empty() || part == pairing) arcbid::bench_paper(pairing);
  if (part.empty() || part == "larger") arcbid::bench_larger();
}
