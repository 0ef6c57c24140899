// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <yaml-cpp/mark.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace arcbid::yaml {

/// Where every value of a config stands, and all that is wrong with it.
class Report {
 public:
  /// `file` stands in front of every line; empty: the values did not come from a file.
  explicit Report(std::string file) : file_(std::move(file)) {}

  /// The key `path` is given at `at`.
  void found(const std::string& path, const YAML::Mark& at) { places_.emplace(path, at); }
  bool has(const std::string& path) const { return places_.contains(path); }

  void problem(const YAML::Mark& at, const std::string& path, const std::string& text);

  /// Values that do not go together. `paths[0]` names the problem; it stands where the first of
  /// `paths` that the file gives stands. Silent when one of them is a problem by itself.
  void conflict(const std::vector<std::string>& paths, const std::string& text);

  /// All problems by position, one line each, in one InputError.
  void throw_if_any() const;

 private:
  struct Problem {
    YAML::Mark at;
    std::string line;
  };
  std::string file_;
  std::map<std::string, YAML::Mark> places_;
  std::set<std::string> wrong_;
  std::vector<Problem> problems_;
};

/// `text` fit for one line of a message: no control characters, not longer than a line.
std::string shown(std::string_view text);

/// "; did you mean NEAREST?", or nothing when no candidate is near `word`: few edits away, or the
/// same but for its unit.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace arcbid::yaml
