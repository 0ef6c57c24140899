// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// The numbers that Liu, Zhang and Wang, "UAV bridge laser scanning path planning based on coverage
/// path arcs" (2021) print, from MATLAB R2019b on an i7-4710HQ. Of Figs. 5 to 11 they print none
/// but kPlanningS.
namespace arcbid::reproduce::paper {

/// Table 1: three runs each; both models are said to cover 100 %.
struct Modelling {
  double spacing_m;  ///< D
  double arcs_s;
  std::uint32_t arcs;  ///< Q of the search space (Q - 1)! / 2
  double units_s;
  std::uint32_t viewpoints;
};
inline constexpr std::array<Modelling, 3> kModelling{{{3, 71.748, 331, 670.976, 3982},
                                                      {4, 44.674, 253, 253.521, 2148},
                                                      {5, 40.526, 205, 130.547, 1321}}};
inline constexpr double kCoveragePercent = 100;

/// Table 2: mean of 20 runs. The header says per cent, and the numbers are shares.
struct Solved {
  double seconds, gap;
};
struct TourSet {
  std::string_view name;
  std::uint32_t cities;
  Solved crsom, ga, aco, pso;
};
inline constexpr std::array<TourSet, 9> kTourSets{{
    {"att48", 48, {0.253, 0.058000}, {4.687, 0.075211}, {18.662, 0.045893}, {16.167, 0.120052}},
    {"eil101", 101, {0.439, 0.056214}, {10.719, 0.093546}, {53.281, 0.116037}, {43.234, 0.102549}},
    {"ch150", 150, {1.072, 0.046320}, {16.652, 0.125231}, {88.261, 0.042151}, {100.561, 0.186523}},
    {"d198", 198, {1.468, 0.061089}, {22.658, 0.118900}, {142.869, 0.051575}, {116.635, 0.143790}},
    {"rand200",
     200,
     {2.031, 0.043950},
     {21.462, 0.162420},
     {142.373, 0.099392},
     {115.258, 0.215457}},
    {"gil262",
     262,
     {2.438, 0.070638},
     {78.107, 0.321450},
     {239.882, 0.100234},
     {268.101, 0.209810}},
    {"a280", 280, {1.911, 0.118066}, {82.157, 0.312690}, {259.315, 0.122540}, {251.527, 0.138931}},
    {"lin318",
     318,
     {3.203, 0.055971},
     {25.362, 0.871511},
     {291.866, 0.094059},
     {447.075, 0.274100}},
    {"pcb442",
     442,
     {6.589, 0.110984},
     {16.423, 0.892595},
     {569.625, 0.154351},
     {600.043, 0.335440}},
}};

/// Section 4.3: mean over N = 3 to 6.
inline constexpr double kPlanningS = 29.019;

}  // namespace arcbid::reproduce::paper
