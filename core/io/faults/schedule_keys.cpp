// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/faults/fault_keys.hpp"

namespace arcbid::yaml {
namespace {

constexpr std::size_t most_faults = 1000;

}  // namespace

const Keys<Topology>& topology_keys() {
  using T = Topology;
  static const Keys<T> keys = {
      field<T>("kind", &T::kind,
               choice<TopologyKind>({{"complete", TopologyKind::complete},
                                     {"ring", TopologyKind::ring},
                                     {"line", TopologyKind::line},
                                     {"star", TopologyKind::star},
                                     {"geometric", TopologyKind::geometric}}),
               "All hear all; by ascending ids: a ring, a chain, the first agent as the hub; or "
               "those whose homes are near."),
      field<T>("radius_m", &T::radius_m, number<double>(0, 1e6), "How near, when geometric."),
  };
  return keys;
}

const Keys<Partition>& partition_keys() {
  using P = Partition;
  static const Keys<P> keys = {
      field<P>("groups", &P::groups,
               list_of(list_of(agent_id(), most_agents, "ids"), most_agents, "groups"),
               "Lists of ids. Nothing crosses between groups; who is in none is alone.", true),
      field<P>(
          "from_s", [](auto& p) -> auto& { return p.when.start_ns; }, seconds(0, longest_s),
          "When the fleet falls apart."),
      field<P>(
          "to_s", [](auto& p) -> auto& { return p.when.end_ns; }, end_seconds(),
          "When it heals; absent: never, or at `until_s`."),
      field<P>("flap_s", &P::flap_ns, seconds(0, longest_s),
               "It holds in every other stretch this long, the first one included; 0: all the "
               "time."),
  };
  return keys;
}

const Keys<FaultSchedule>& schedule_keys() {
  using S = FaultSchedule;
  static const Keys<S> keys = {
      field<S>("name", &S::name, title(), "Names the schedule in logs and reports."),
      field<S>("seed", &S::seed, number<std::uint64_t>(0, 4294967295), "Seed of all chance."),
      field<S>("until_s", &S::until_ns, optional_of(seconds(0, longest_s)),
               "All faults of links and all partitions end here; absent: they go on."),
      field<S>("topology", &S::topology, mapping(topology_keys()), "Which links exist at all."),
      field<S>("links", &S::links,
               list_of(mapping(link_keys()), most_faults, "faults of links", Layout::block),
               "Faults of directed links. All that apply to a message act, one after another."),
      field<S>("partitions", &S::partitions,
               list_of(mapping(partition_keys()), most_faults, "partitions", Layout::block),
               "Times when the fleet falls apart."),
      field<S>("agents", &S::agents,
               list_of(agent_fault(), most_faults, "faults of agents", Layout::block),
               "Faults of processes."),
  };
  return keys;
}

}  // namespace arcbid::yaml
