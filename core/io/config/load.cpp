// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/base/error.hpp"
#include "core/io/config.hpp"
#include "core/io/config/keys.hpp"
#include "core/io/config/together.hpp"

namespace arcbid {
namespace {

constexpr std::size_t most_bytes = 256 * 1024;

std::string read_text(const std::filesystem::path& file) {
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("{}: is a folder, not a config file", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  std::string text(most_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// What yaml-cpp takes but a person did not mean, or does not explain well.
void check_text(const std::string& text, const std::string& file) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: larger than {} kB: no config", file, most_bytes / 1024));
  if (text.find('\0') != std::string::npos)
    throw InputError(fmt::format("{}: has zero bytes: no text file in UTF-8", file));
  yaml::Report report(file);
  YAML::Mark at;
  for (std::size_t start = 0; start < text.size(); ++at.line) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::size_t first = std::min(text.find_first_not_of(" \t\r", start), end);
    const std::size_t tab = text.find('\t', start);
    if (tab < first && first < end) {
      at.column = static_cast<int>(tab - start);
      report.problem(at, "", "a tab; YAML is indented with spaces only");
    }
    start = end + 1;
  }
  report.throw_if_any();
}

/// Where the documents of a YAML stream start.
class DocumentStarts : public YAML::EventHandler {
 public:
  std::vector<YAML::Mark> starts;
  void OnDocumentStart(const YAML::Mark& at) override { starts.push_back(at); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// The first two at most: yaml-cpp 0.7 takes a stray comma for endlessly many empty documents, and
/// its LoadAll collects them until memory ends.
std::vector<YAML::Mark> document_starts(const std::string& text) {
  std::istringstream in(text);
  YAML::Parser parser(in);
  DocumentStarts documents;
  while (documents.starts.size() < 2 && parser.HandleNextDocument(documents)) continue;
  return documents.starts;
}

YAML::Node parse_yaml(const std::string& text, const std::string& file) {
  const auto fail = [&](const YAML::Mark& at, const std::string& what) {
    yaml::Report report(file);
    report.problem(at, "", what);
    report.throw_if_any();
  };
  YAML::Node root;
  try {
    if (const auto starts = document_starts(text); starts.size() > 1)
      fail(starts[1], "not one YAML document: another starts here");
    root = YAML::Load(text);
  } catch (const YAML::DeepRecursion& e) {
    fail(e.mark, "not YAML: nested too deeply");
  } catch (const YAML::Exception& e) {
    fail(e.mark, "not YAML: " + yaml::shown(e.msg));
  }
  if (root.IsNull())
    throw InputError(fmt::format("{}: empty; write {{}} for a config of defaults only", file));
  return root;
}

/// What a value means depends on others: where files are, what a UAV has by default.
void resolve(Config& config, const std::filesystem::path& folder, const yaml::Report& report) {
  FleetConfig& fleet = config.fleet;
  if (std::optional<std::filesystem::path>& file = config.structure.file)
    file = std::filesystem::absolute(folder / *file).lexically_normal();
  for (std::size_t i = 0; i < fleet.uavs.size(); ++i) {
    const auto is_given = [&](const char* key) {
      return report.has(fmt::format("fleet.uavs[{}].{}", i, key));
    };
    Uav& uav = fleet.uavs[i];
    if (!is_given("speed_mps")) uav.speed_mps = fleet.speed_mps;
    if (!is_given("endurance_s")) uav.endurance_s = fleet.endurance_s;
    if (!is_given("payload")) uav.payload = fleet.payload;
  }
  if (!fleet.uavs.empty() && !report.has("fleet.agents"))
    fleet.agents = static_cast<std::uint32_t>(fleet.uavs.size());
}

}  // namespace

Config parse_config(const std::string& text, const std::filesystem::path& file) {
  check_text(text, file.string());
  const YAML::Node root = parse_yaml(text, file.string());
  Config config;
  yaml::Report report(file.string());
  yaml::read_mapping({root, root.Mark(), ""}, yaml::config_keys(), config, report);
  resolve(config, file.parent_path(), report);
  yaml::check_together(config, report);
  report.throw_if_any();
  std::sort(config.fleet.uavs.begin(), config.fleet.uavs.end(),
            [](const Uav& a, const Uav& b) { return a.id < b.id; });
  return config;
}

Config load_config(const std::filesystem::path& file) {
  return parse_config(read_text(file), file);
}

}  // namespace arcbid
