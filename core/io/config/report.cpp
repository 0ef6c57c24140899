// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/config/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "core/base/error.hpp"

namespace arcbid::yaml {
namespace {

// A hostile file can be wrong in every byte; nobody reads more than this.
constexpr std::size_t most_lines = 50;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

}  // namespace

void Report::problem(const YAML::Mark& at, const std::string& path, const std::string& text) {
  wrong_.insert(path);
  const bool has_place = !file_.empty() && !at.is_null();
  std::string line = file_;
  if (has_place) line += fmt::format(":{}:{}", at.line + 1, at.column + 1);
  if (!line.empty()) line += ": ";
  if (!path.empty()) line += shown(path) + ": ";
  problems_.push_back({has_place ? at : YAML::Mark::null_mark(), line + text});
}

void Report::conflict(const std::vector<std::string>& paths, const std::string& text) {
  if (std::any_of(paths.begin(), paths.end(), [&](const auto& p) { return wrong_.contains(p); }))
    return;
  const auto given =
      std::find_if(paths.begin(), paths.end(), [&](const auto& p) { return has(p); });
  problem(given == paths.end() ? YAML::Mark::null_mark() : places_.at(*given), paths.front(), text);
}

void Report::throw_if_any() const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
  });
  std::vector<std::string> lines;
  for (const Problem& p : sorted) {
    if (lines.size() == most_lines) {
      lines.push_back(fmt::format("{}: and {} more", file_, sorted.size() - most_lines));
      break;
    }
    lines.push_back(p.line);
  }
  throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string line(text.substr(0, longest));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text.size() > longest ? line + "..." : line;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  // Long words are no misspellings, and the distance costs time.
  if (word.size() > 60) return "";
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const bool lacks_unit = candidate.starts_with(std::string(word) + "_");
    const std::size_t distance = lacks_unit ? 1 : edit_distance(word, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = &candidate;
  }
  return nearest ? fmt::format("; did you mean {}?", *nearest) : "";
}

}  // namespace arcbid::yaml
