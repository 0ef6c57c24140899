// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/error.hpp"
#include "core/io/faults/document.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/faults/fault_keys.hpp"

namespace arcbid {
namespace {

bool is_preset(const std::string& name) {
  return std::any_of(fault_presets().begin(), fault_presets().end(),
                     [&](const FaultPreset& p) { return p.name == name; });
}

bool looks_like_a_file(const std::string& name) {
  std::error_code ignored;
  return name.find('/') != std::string::npos || name.ends_with(".yaml") || name.ends_with(".yml") ||
         std::filesystem::exists(name, ignored);
}

}  // namespace

FaultSchedule parse_faults(const std::string& text, const std::filesystem::path& file,
                           const std::vector<AgentId>& fleet) {
  const YAML::Node root = yaml::parse_document(text, file.string(), "a fault file");
  FaultSchedule schedule;
  yaml::Report report(file.string());
  yaml::read_fields({root, root.Mark(), ""}, yaml::schedule_keys(), schedule, report);
  yaml::check_together(schedule, fleet, report);
  report.throw_if_any();
  return schedule;
}

FaultSchedule load_faults(const std::string& preset_or_file, const std::vector<AgentId>& fleet) {
  if (is_preset(preset_or_file)) return preset(preset_or_file, fleet);
  if (looks_like_a_file(preset_or_file))
    return parse_faults(yaml::read_text(preset_or_file, "a fault file"), preset_or_file, fleet);
  std::vector<std::string> names;
  for (const FaultPreset& p : fault_presets()) names.push_back(p.name);
  throw InputError(fmt::format("faults: {} is neither a file nor a preset{}; presets: {}",
                               yaml::shown(preset_or_file),
                               yaml::did_you_mean(preset_or_file, names), fmt::join(names, ", ")));
}

}  // namespace arcbid
