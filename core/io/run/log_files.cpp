// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/log_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.hpp"

namespace arcbid {

std::vector<std::filesystem::path> agents_logs(const std::filesystem::path& run) {
  std::error_code failed;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(run / "logs", failed))
    if (entry.path().extension() == ".sqlite" &&
        entry.path().filename().string().starts_with("agent_"))
      files.push_back(entry.path());
  if (failed)
    throw InputError(fmt::format("{}: {}; legal: a run directory, or a recorded world's",
                                 (run / "logs").string(), failed.message()));
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace arcbid
