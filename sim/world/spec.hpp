// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/arcs/mission.hpp"
#include "core/faults/schedule.hpp"

namespace arcbid {

/// Both ends included.
template <class T>
struct Range {
  T least{}, most{};
};

/// What can be mixed into a world, each by its own odds.
enum class WorldFault : std::uint8_t {
  loss,
  burst,
  size_loss,
  delay,
  duplicate,
  stale,
  capacity,
  clog,
  cut,
  flap,
  reach,
  obstacle,
  partition,
  crash,
  crash_return,
  clock_step_back,  ///< a crash, and a return under a clock that was set back meanwhile
  pause,
  late,
  clock,
  twin,
  malformed,
  over_bid
};
inline constexpr std::array<std::string_view, 22> world_fault_names{
    "loss",      "burst",   "size_loss",    "delay",
    "duplicate", "stale",   "capacity",     "clog",
    "cut",       "flap",    "reach",        "obstacle",
    "partition", "crash",   "crash_return", "clock_step_back",
    "pause",     "late",    "clock",        "twin",
    "malformed", "over_bid"};

/// How missions lie in space. On a grid gains tie again and again.
enum class Layout : std::uint8_t { scattered, clustered, grid };
inline constexpr std::array<std::string_view, 3> layout_names{"scattered", "clustered", "grid"};

inline constexpr std::array<std::string_view, 5> topology_names{"complete", "ring", "line", "star",
                                                                "geometric"};

/// What worlds are drawn from: a config of `arcbid sim`.
struct WorldSettings {
  std::string name = "worlds";
  Range<std::uint32_t> agents{2, 12};
  Range<std::uint32_t> tasks{1, 60};
  std::vector<PolicyKind> policies{PolicyKind::claims};
  std::vector<ScoreKind> scores{ScoreKind::minimax};
  std::vector<TopologyKind> topologies{TopologyKind::complete};
  std::vector<Layout> layouts{Layout::scattered};
  std::vector<TradesKind> trades{TradesKind::off};
  double bundle_limit = 0;  ///< odds of a limit L_t
  double endurance = 0;     ///< odds of UAVs with limited endurance, each its own
  double payloads = 0;      ///< odds of UAVs and arcs with different payloads
  TimeNs tick_ns = 20'000'000;
  Range<TimeNs> lease_ns{400'000'000, 2'000'000'000};
  Range<TimeNs> latency_ns{1'000'000, 5'000'000};  ///< of every message, whatever goes wrong
  TimeNs until_ns = 3'000'000'000;                 ///< faults are off from here on
  std::array<double, world_fault_names.size()> odds{};
  Range<double> loss{0.05, 0.6};  ///< of the faults loss and burst
  bool price = true;              ///< run every world without its faults too
};

/// One world, as plain data: what is run is a function of this alone.
struct WorldSpec {
  std::uint64_t seed = 1;
  Mission mission;
  FaultSchedule faults;
  Range<TimeNs> latency_ns;
  std::shared_ptr<const Transit> transit = {};  ///< none: made from the mission
  bool compares_with_greedy = true;  ///< at the end; the work grows with the tasks' third power
};

/// The world of `seed`: a pure function.
WorldSpec make_world(const WorldSettings& settings, std::uint64_t seed);

/// The same world, and nothing goes wrong.
WorldSpec without_faults(WorldSpec spec);

/// When the last fault ends, a clock that ran ahead included: from here on messages get through and
/// nobody comes or goes. Zero without faults.
TimeNs calm_ns(const WorldSpec& spec);

/// The latest time at which a fault begins or ends, those aside that go on until `until_ns`.
TimeNs last_turn_ns(const FaultSchedule& faults);

/// The world in one line, for people.
std::string summary(const WorldSpec& spec);

}  // namespace arcbid
