// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/base/error.hpp"
#include "core/io/faults/fault_files.hpp"
#include "core/io/faults/fault_keys.hpp"

namespace arcbid {
namespace {

constexpr std::size_t most_bytes = 256 * 1024;

std::string read_text(const std::filesystem::path& file) {
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("{}: is a folder, not a fault file", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  std::string text(most_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// What yaml-cpp takes but a person did not mean: tabs, and a second document, which it skips.
void check_text(const std::string& text, const std::string& file) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: larger than {} kB: no fault file", file, most_bytes / 1024));
  if (text.find('\0') != std::string::npos)
    throw InputError(fmt::format("{}: has zero bytes: no text file in UTF-8", file));
  yaml::Report report(file);
  std::istringstream lines(text);
  YAML::Mark at;
  bool begun = false;
  for (std::string line; std::getline(lines, line); ++at.line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    at.column = 0;
    if (first == std::string::npos || line[first] == '#') continue;
    if (begun && line.starts_with("---"))
      report.problem(at, "", "not one YAML document: another starts here");
    begun = true;
    at.column = static_cast<int>(std::min(line.find('\t'), first));
    if (line.find('\t') < first) report.problem(at, "", "a tab; YAML is indented with spaces only");
  }
  report.throw_if_any();
}

YAML::Node parse_yaml(const std::string& text, const std::string& file) {
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& e) {
    yaml::Report report(file);
    report.problem(e.mark, "", "not YAML: " + yaml::shown(e.msg));
    report.throw_if_any();
  }
  if (root.IsNull())
    throw InputError(fmt::format("{}: empty; write {{}} for a schedule without faults", file));
  return root;
}

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
  check_text(text, file.string());
  const YAML::Node root = parse_yaml(text, file.string());
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
    return parse_faults(read_text(preset_or_file), preset_or_file, fleet);
  std::vector<std::string> names;
  for (const FaultPreset& p : fault_presets()) names.push_back(p.name);
  throw InputError(fmt::format("faults: {} is neither a file nor a preset{}; presets: {}",
                               yaml::shown(preset_or_file),
                               yaml::did_you_mean(preset_or_file, names), fmt::join(names, ", ")));
}

}  // namespace arcbid
