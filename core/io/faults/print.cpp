// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/faults/fault_files.hpp"
#include "core/io/faults/fault_keys.hpp"

namespace arcbid {
namespace {

std::string row(const std::string& key, const std::string& legal, const std::string& default_value,
                const std::string& meaning) {
  return fmt::format("| `{}` | {} | {} | {} |\n", key, legal, default_value, meaning);
}

template <class Owner>
std::string rows(const std::string& prefix, const yaml::Keys<Owner>& keys) {
  std::string text;
  for (const yaml::Key<Owner>& key : keys) {
    const std::string value = key.print(Owner{});
    const bool is_absent = value.empty() || value == "\"\"";
    text += row(prefix + key.name, key.legal,
                key.required ? "required"
                : is_absent  ? "absent"
                             : "`" + value + "`",
                key.meaning);
  }
  return text;
}

std::string agent_rows() {
  std::string text =
      row("agents[].agent", yaml::agent_or_coordinator().legal, "required", "Whose fault it is.");
  for (const yaml::AgentFaultKey& of_kind : yaml::agent_fault_keys()) {
    const std::string name = "agents[]." + of_kind.name;
    text += row(name, yaml::mapping(of_kind.keys).legal, "absent", of_kind.meaning);
    text += rows(name + ".", of_kind.keys);
  }
  return text;
}

}  // namespace

std::string to_yaml(const FaultSchedule& schedule) {
  const auto lines = yaml::printed_fields(yaml::schedule_keys(), schedule);
  return lines.empty() ? "{}\n" : fmt::format("{}\n", fmt::join(lines, "\n"));
}

std::string fault_reference() {
  return "| key | legal | default | meaning |\n|---|---|---|---|\n" +
         rows("", yaml::schedule_keys()) + rows("topology.", yaml::topology_keys()) +
         rows("links[].", yaml::link_keys()) + rows("links[].burst.", yaml::burst_keys()) +
         rows("links[].reach.", yaml::reach_keys()) +
         rows("links[].obstacles[].", yaml::obstacle_keys()) +
         rows("links[].delay.", yaml::delay_keys()) +
         rows("links[].capacity.", yaml::capacity_keys()) +
         rows("partitions[].", yaml::partition_keys()) + agent_rows();
}

std::string fault_preset_reference() {
  std::string table = "| preset | what happens |\n|---|---|\n";
  for (const FaultPreset& p : fault_presets())
    table += fmt::format("| `{}` | {} |\n", p.name, p.meaning);
  return table;
}

}  // namespace arcbid
