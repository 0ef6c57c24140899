// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/faults/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/base/error.hpp"
#include "core/io/config/report.hpp"

namespace arcbid::yaml {
namespace {

constexpr std::size_t most_bytes = 256 * 1024;

}  // namespace

std::string read_text(const std::filesystem::path& file, const std::string& what) {
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("{}: is a folder, not {}", file.string(), what));
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  std::string text(most_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

namespace {

void check_text(const std::string& text, const std::string& file, const std::string& what) {
  if (text.size() > most_bytes)
    throw InputError(fmt::format("{}: larger than {} kB: not {}", file, most_bytes / 1024, what));
  if (text.find('\0') != std::string::npos)
    throw InputError(fmt::format("{}: has zero bytes: no text file in UTF-8", file));
  Report report(file);
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

}  // namespace

YAML::Node parse_document(const std::string& text, const std::string& file,
                          const std::string& what) {
  check_text(text, file, what);
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& e) {
    Report report(file);
    report.problem(e.mark, "", "not YAML: " + shown(e.msg));
    report.throw_if_any();
  }
  if (root.IsNull())
    throw InputError(fmt::format("{}: empty; write {{}} for {} of defaults", file, what));
  return root;
}

}  // namespace arcbid::yaml
