// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/arcs/mission.hpp"

namespace arcbid::testing {

/// A folder of one's own that is gone afterwards.
struct Folder {
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path path;
};

/// A world of five agents under this policy, with losses, a death and a return, on record.
void record_world(PolicyKind policy, std::uint64_t seed, const std::filesystem::path& directory);

}  // namespace arcbid::testing
