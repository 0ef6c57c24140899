// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/checker/checker.hpp"

namespace arcbid {

/// A run's documents, valid as they come; a test breaks one thing and writes them.
struct RunDocuments {
  nlohmann::json arcs, agent_1, agent_2;
};
RunDocuments valid_run();

/// A run directory of its own in the temporary folder, removed at the end.
class RunFolder {
 public:
  RunFolder();
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  void write(const RunDocuments& documents) const;
  void write_text(const std::string& name, const std::string& text) const;
  std::string read_text(const std::string& name) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The four verdicts as letters: C(onflict-free) c(omplete) A(rcs conserved) R(outes valid); '-'
/// for those that fail.
std::string verdicts(const CheckReport& report);

/// All problems, one a line, for messages.
std::string listed(const CheckReport& report);

}  // namespace arcbid
