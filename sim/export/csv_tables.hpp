// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/seconds.hpp"
#include "sim/export/csv.hpp"
#include "sim/export/statements.hpp"

namespace arcbid {

/// The tables that a run's steps fill, one step after the other.
class StepTables {
 public:
  StepTables(const RunArchive& run, const std::filesystem::path& folder);
  void take(const RunStep& at);
  void close();

 private:
  void take_decision(const RunStep& at);
  void take_bids(const RunStep& at);
  void take_messages(const RunStep& at);
  void take_events(const RunStep& at);

  const RunArchive& run_;
  CsvFile decisions_, bids_, messages_, events_;
  Statements statements_;
};

void write_owners(const RunArchive& run, const Playback& playback,
                  const std::filesystem::path& file);
void write_routes(const RunArchive& run, const std::filesystem::path& file);

}  // namespace arcbid
