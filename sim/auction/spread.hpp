// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/checker/checker.hpp"

namespace arcbid {

/// How evenly a fleet is loaded: E = N / (sum (T_i - mu)^2 + N), eq. 18 of the paper. 1: all alike.
/// It depends on the unit of the loads: counts and seconds are not to be compared. 0 without loads.
double uniformity(std::span<const double> loads);

/// The loads' standard deviation over their mean: whatever the unit, 0 where all are alike. 0 where
/// the mean is.
double variation(std::span<const double> loads);
/// Of the flight times of a run.
double cv_time(const CheckReport& report);

}  // namespace arcbid
