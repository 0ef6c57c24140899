// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace arcbid {

/// What a log's write-ahead log holds, by SQLite's own rule: frames count up to the last whole
/// commit before the first damaged frame, and SQLite silently leaves out the rest.
struct WalState {
  std::size_t frames = 0;            ///< that count
  std::size_t commits = 0;           ///< among them
  std::size_t lost_commits = 0;      ///< whole ones behind damage, which do not count any more
  std::size_t unfinished_bytes = 0;  ///< of a commit that was being written, or was cut off
};

/// `file`: the log's; its write-ahead log lies beside it. None: all zero.
WalState wal_state(const std::filesystem::path& file);

}  // namespace arcbid
