// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace arcbid {

/// RUN/running, locked while the launcher runs. The kernel lets go of it however the launcher ends,
/// so that nobody takes a run for a live one whose launcher was killed.
class RunLock {
 public:
  /// Makes the directory and the file. A place that knows no locks costs the mark, not the run.
  explicit RunLock(const std::filesystem::path& run);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  std::filesystem::path file_;
  int fd_;
};

/// Whether a launcher runs this run, and has not yet written how it ended.
bool goes_on(const std::filesystem::path& run);

}  // namespace arcbid
