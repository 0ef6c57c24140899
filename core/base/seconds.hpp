// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.hpp"

namespace arcbid {

/// For people and for tables: divided, so that it prints as "0.25", not "0.25000000000000006".
constexpr double seconds(TimeNs ns) {
  return static_cast<double>(ns) / 1e9;
}

}  // namespace arcbid
