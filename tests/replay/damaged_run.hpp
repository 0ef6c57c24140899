// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "sim/replay/doctor.hpp"
#include "tests/auction/fleet.hpp"
#include "tests/export/recorded_run.hpp"

namespace arcbid::testing {

/// Records by their numbers, asked for one by one from SQLite itself: bodies, of those that can be
/// read and are of a kind that can.
std::map<std::int64_t, std::string> readable(const std::filesystem::path& log, std::int64_t most);

std::string bytes_of(const std::filesystem::path& file);
void put_bytes(const std::filesystem::path& file, const std::string& bytes);

/// Writes another body where the record of that number is.
void put_record(const std::filesystem::path& log, std::int64_t seq, const std::string& body);

/// The numbers up to `most` that a report says are intact.
std::set<std::int64_t> intact_by(const LogReport& report, std::int64_t most);

/// A run of three in a folder of its own; its logs are there to be damaged.
class DamagedRun : public ::testing::Test {
 protected:
  DamagedRun();
  ~DamagedRun() override;

  /// 12 s, then all end well.
  void record(std::uint32_t arcs = 20);
  /// The same, but agent 2 is killed before; its log is in the write-ahead log.
  void record_killed();
  LogReport report_of(std::uint32_t agent) const;

  std::filesystem::path folder, run;
  std::filesystem::path log;                    ///< agent 2's
  std::map<std::int64_t, std::string> records;  ///< what it holds
  std::int64_t last = 0;                        ///< the highest number
};

}  // namespace arcbid::testing
