// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "core/io/faults/fault_keys.hpp"

namespace arcbid::yaml {
namespace {

constexpr double ns_per_s = 1e9, ns_per_ms = 1e6;
constexpr TimeNs no_end_ns = Window{}.end_ns;

double in_s(TimeNs t) {
  return static_cast<double>(t) / ns_per_s;
}

/// Checks the parts of one schedule; `path` is where a part stands: "links[2]".
class Checker {
 public:
  Checker(const FaultSchedule& schedule, const std::vector<AgentId>& fleet, Report& report)
      : schedule_(schedule), fleet_(fleet), report_(report) {}

  void check_topology();
  void check_link(const LinkFault& fault, const std::string& path);
  void check_partition(const Partition& partition, const std::string& path);
  void check_agent(std::size_t index);

 private:
  /// Something is wrong with `words[0]` below `path`, given the other words.
  void conflict(const std::string& path, const std::vector<std::string>& words,
                const std::string& text) {
    std::vector<std::string> paths;
    for (const std::string& word : words) paths.push_back(path + "." + word);
    paths.push_back(path);
    report_.conflict(paths, text);
  }
  void check_window(const Window& when, const std::string& path);
  void check_known(AgentId agent, const std::string& path);
  void check_ids(const std::vector<AgentId>& ids, const std::string& path);
  void check_burst(const Burst& burst, const std::string& path);
  void check_delay(const Delay& delay, const std::string& path);
  void check_reach(const LinkFault& fault, const std::string& path);
  void check_effect(const LinkFault& fault, const std::string& path);
  void check_down_once(std::size_t index, const std::string& path);

  const FaultSchedule& schedule_;
  const std::vector<AgentId>& fleet_;
  Report& report_;
};

void Checker::check_topology() {
  const bool is_geometric = schedule_.topology.kind == TopologyKind::geometric;
  const double radius_m = schedule_.topology.radius_m;
  if (is_geometric && radius_m <= 0)
    conflict("topology", {"radius_m", "kind"}, "missing; legal with geometric: more than 0");
  if (!is_geometric && radius_m > 0)
    conflict("topology", {"radius_m", "kind"},
             fmt::format("{} means nothing; legal with geometric only", radius_m));
}

void Checker::check_window(const Window& when, const std::string& path) {
  if (when.end_ns <= when.start_ns)
    conflict(path, {"to_s", "from_s"},
             fmt::format("{} is not after from_s, {}", in_s(when.end_ns), in_s(when.start_ns)));
  if (schedule_.until_ns && when.start_ns >= *schedule_.until_ns)
    report_.conflict({path + ".from_s", "until_s", path},
                     fmt::format("{} is not before until_s, {}", in_s(when.start_ns),
                                 in_s(*schedule_.until_ns)));
}

void Checker::check_known(AgentId agent, const std::string& path) {
  if (fleet_.empty() || agent.value == 0 ||
      std::find(fleet_.begin(), fleet_.end(), agent) != fleet_.end())
    return;
  std::vector<std::uint32_t> ids;
  for (const AgentId id : fleet_) ids.push_back(id.value);
  report_.conflict(
      {path}, fmt::format("{} is not in the fleet; legal: {}", agent.value, fmt::join(ids, ", ")));
}

void Checker::check_ids(const std::vector<AgentId>& ids, const std::string& path) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string place = fmt::format("{}[{}]", path, i);
    const std::string& at = report_.has(place) ? place : path;  // a single id stands without a list
    check_known(ids[i], at);
    if (std::find(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(i), ids[i]) !=
        ids.begin() + static_cast<std::ptrdiff_t>(i))
      report_.conflict({at}, fmt::format("{} is listed twice", ids[i].value));
  }
}

void Checker::check_burst(const Burst& burst, const std::string& path) {
  if (burst.good_loss > burst.mean_loss || burst.bad_loss <= burst.mean_loss) {
    conflict(path, {"mean_loss", "good_loss", "bad_loss"},
             fmt::format("{} is outside [good_loss, bad_loss), [{}, {})", burst.mean_loss,
                         burst.good_loss, burst.bad_loss));
    return;
  }
  // The good state lasts one message at least; so the bad one lasts as long as the odds say.
  const double least_length =
      (burst.mean_loss - burst.good_loss) / (burst.bad_loss - burst.mean_loss);
  if (burst.mean_length < least_length)
    conflict(path, {"mean_length", "mean_loss", "good_loss", "bad_loss"},
             fmt::format("{} is too short for a mean loss of {}; at least {:.6g} is legal",
                         burst.mean_length, burst.mean_loss, least_length));
}

void Checker::check_delay(const Delay& delay, const std::string& path) {
  const bool is_uniform = delay.kind == Delay::Kind::uniform,
             is_exponential = delay.kind == Delay::Kind::exponential;
  if (is_uniform && delay.most_ns < delay.least_ns)
    conflict(
        path, {"most_ms", "least_ms", "kind"},
        fmt::format("{} is less than least_ms, {}", static_cast<double>(delay.most_ns) / ns_per_ms,
                    static_cast<double>(delay.least_ns) / ns_per_ms));
  if (!is_uniform && delay.most_ns > 0)
    conflict(path, {"most_ms", "kind"}, "means nothing; legal with kind uniform only");
  if (is_exponential && delay.mean_ns <= 0)
    conflict(path, {"mean_ms", "kind"}, "missing; legal with kind exponential: more than 0");
  if (!is_exponential && delay.mean_ns > 0)
    conflict(path, {"mean_ms", "kind"}, "means nothing; legal with kind exponential only");
}

void Checker::check_reach(const LinkFault& fault, const std::string& path) {
  if (fault.reach && fault.reach->none_m < fault.reach->full_m)
    conflict(path + ".reach", {"none_m", "full_m"},
             fmt::format("{} is less than full_m, {}", fault.reach->none_m, fault.reach->full_m));
  for (std::size_t i = 0; i < fault.obstacles.size(); ++i)
    if ((fault.obstacles[i].least_m.array() > fault.obstacles[i].most_m.array()).any())
      conflict(fmt::format("{}.obstacles[{}]", path, i), {"most_m", "least_m"},
               "is less than least_m along an axis");
}

void Checker::check_effect(const LinkFault& fault, const std::string& path) {
  const bool acts = fault.loss > 0 || fault.loss_per_kb > 0 || fault.burst || fault.reach ||
                    !fault.obstacles.empty() || fault.delay || fault.duplicate > 0 ||
                    fault.stale > 0 || fault.capacity || fault.clog || fault.cut;
  if (fault.flap_ns > 0 && !fault.cut) {
    conflict(path, {"flap_s"}, "means nothing without cut: true");
  } else if ((fault.stale > 0) != (fault.stale_ns > 0)) {
    conflict(path, {fault.stale > 0 ? "stale_s" : "stale", fault.stale > 0 ? "stale" : "stale_s"},
             "missing; legal: stale and stale_s together, each more than 0");
  } else if (!acts) {
    // Silent when one of its keys is wrong: that one was to act.
    std::vector<std::string> paths = {path};
    for (const Key<LinkFault>& key : link_keys()) paths.push_back(path + "." + key.name);
    report_.conflict(paths,
                     "does nothing; legal: at least one of loss, loss_per_kb, burst, reach, "
                     "obstacles, cut, delay, duplicate, stale, capacity, clog");
  }
  if (fault.clog && fault.when.end_ns == no_end_ns && !schedule_.until_ns)
    conflict(path, {"clog"}, "has no end; give to_s or until_s");
}

void Checker::check_link(const LinkFault& fault, const std::string& path) {
  check_ids(fault.from, path + ".from");
  check_ids(fault.to, path + ".to");
  check_window(fault.when, path);
  check_effect(fault, path);
  if (fault.burst) check_burst(*fault.burst, path + ".burst");
  if (fault.delay) check_delay(*fault.delay, path + ".delay");
  check_reach(fault, path);
}

void Checker::check_partition(const Partition& partition, const std::string& path) {
  check_window(partition.when, path);
  if (partition.groups.empty()) conflict(path, {"groups"}, "no group; legal: one or more");
  std::set<AgentId> members;
  for (std::size_t g = 0; g < partition.groups.size(); ++g) {
    const std::string group = fmt::format("{}.groups[{}]", path, g);
    if (partition.groups[g].empty()) report_.conflict({group}, "an empty group; leave it out");
    for (std::size_t i = 0; i < partition.groups[g].size(); ++i) {
      const AgentId agent = partition.groups[g][i];
      const std::string place = fmt::format("{}[{}]", group, i);
      check_known(agent, place);
      if (!members.insert(agent).second)
        report_.conflict({place}, fmt::format("{} is in a group already", agent.value));
    }
  }
}

/// A process cannot be stopped, killed or absent while it is so already.
void Checker::check_down_once(std::size_t index, const std::string& path) {
  const auto down = [](const AgentFault& fault) -> std::optional<Window> {
    if (fault.kind == AgentFaultKind::late) return Window{0, fault.for_ns.value_or(0)};
    if (fault.kind != AgentFaultKind::crash && fault.kind != AgentFaultKind::pause)
      return std::nullopt;
    return Window{fault.at_ns, fault.for_ns ? fault.at_ns + *fault.for_ns : no_end_ns};
  };
  const std::vector<AgentFault>& all = schedule_.agents;
  const std::optional<Window> mine = down(all[index]);
  for (std::size_t i = 0; mine && i < index; ++i) {
    const std::optional<Window> other = down(all[i]);
    if (all[i].agent == all[index].agent && other && mine->start_ns < other->end_ns &&
        other->start_ns < mine->end_ns)
      report_.conflict({path}, fmt::format("overlaps with agents[{}]: that agent is down", i));
  }
}

void Checker::check_agent(std::size_t index) {
  const AgentFault& fault = schedule_.agents[index];
  const std::string path = fmt::format("agents[{}]", index);
  check_known(fault.agent, path + ".agent");
  if (fault.agent.value == 0 && report_.has(path + ".agent") &&
      fault.kind != AgentFaultKind::crash && fault.kind != AgentFaultKind::pause)
    report_.conflict({path + ".agent"}, "coordinator can only crash or pause");
  if (fault.kind == AgentFaultKind::clock && fault.offset_ns == 0 && fault.drift == 0)
    conflict(path + ".clock", {"offset_s", "drift"}, "does nothing; legal: offset_s or drift");
  check_down_once(index, path);
}

}  // namespace

void check_together(const FaultSchedule& schedule, const std::vector<AgentId>& fleet,
                    Report& report) {
  Checker checker(schedule, fleet, report);
  checker.check_topology();
  for (std::size_t i = 0; i < schedule.links.size(); ++i)
    checker.check_link(schedule.links[i], fmt::format("links[{}]", i));
  for (std::size_t i = 0; i < schedule.partitions.size(); ++i)
    checker.check_partition(schedule.partitions[i], fmt::format("partitions[{}]", i));
  for (std::size_t i = 0; i < schedule.agents.size(); ++i) checker.check_agent(i);
}

}  // namespace arcbid::yaml
