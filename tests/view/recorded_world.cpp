// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/view/recorded_world.hpp"

#include <stdlib.h>

#include "sim/world/world_log.hpp"

namespace arcbid::testing {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "arcbid-view-XXXXXX").string();
  path = mkdtemp(name.data());
}

Folder::~Folder() {
  std::filesystem::remove_all(path);
}

void record_world(PolicyKind policy, std::uint64_t seed, const std::filesystem::path& directory) {
  WorldSettings settings;
  settings.agents = {5, 5};
  settings.tasks = {20, 20};
  settings.policies = {policy};
  settings.odds = {};
  settings.odds[static_cast<std::size_t>(WorldFault::loss)] = 1;
  settings.odds[static_cast<std::size_t>(WorldFault::crash_return)] = 1;
  const WorldSpec spec = make_world(settings, seed);
  WorldLog log(spec, directory);
  log.write_result(run_world(spec, {}, &log));
}

}  // namespace arcbid::testing
