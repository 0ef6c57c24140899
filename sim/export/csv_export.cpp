// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/csv_export.hpp"

#include "core/base/error.hpp"
#include "sim/export/csv_tables.hpp"

namespace arcbid {

std::vector<std::filesystem::path> csv_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  for (const char* name : {"decisions", "bids", "messages", "owners", "events", "routes"})
    out.push_back(folder / (std::string(name) + ".csv"));
  return out;
}

void export_csv(const RunArchive& run, const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw RunError(fmt::format("{}: cannot be made: {}", folder.string(), failed.message()));
  const Playback playback(run);
  StepTables tables(run, folder);
  for_each_step(run, playback.moments(), [&](const RunStep& at) { tables.take(at); });
  tables.close();
  write_owners(run, playback, folder / "owners.csv");
  write_routes(run, folder / "routes.csv");
}

}  // namespace arcbid
