// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/trades/tours.hpp"

namespace arcbid {

/// A pair of end points that a change is to bring next to each other in one tour.
struct Wish {
  Node one = 0;    ///< of a lot
  Node other = 0;  ///< of another lot, or a home: then the even number is left, the odd one reached
};

/// Takes the lot of `one`, and `more` lots behind it, to where `other` is.
std::optional<Change> move_lots(const Tours& tours, const Wish& wish, std::uint32_t more);

/// The same, for `more_back` + 1 lots that stand there now: they go the other way, `reversed` or
/// not.
std::optional<Change> swap_lots(const Tours& tours, const Wish& wish, std::uint32_t more,
                                std::uint32_t more_back, bool reversed);

/// Turns part of a tour round, or has two tours exchange what they fly from some point on.
std::optional<Change> cross(const Tours& tours, const Wish& wish);

}  // namespace arcbid
