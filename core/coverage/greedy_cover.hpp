// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/coverage/seer.hpp"

namespace arcbid {

/// Greedy set cover: positions in `sets`, in the order in which they were chosen, that together
/// hold every sample that any of the sets holds. The set that adds most comes first; of equal ones
/// the earlier.
std::vector<std::size_t> greedy_cover(const std::vector<Seen>& sets, std::size_t samples);

}  // namespace arcbid
