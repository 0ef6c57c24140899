// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "tests/auction/fleet.hpp"

namespace arcbid::testing {

/// The same items in a random order (Fisher, Yates).
template <class Item>
std::vector<Item> shuffled(std::vector<Item> items, Dice& dice) {
  for (std::size_t left = items.size(); left > 1; --left)
    std::swap(items[left - 1], items[dice.below(left)]);
  return items;
}

}  // namespace arcbid::testing
