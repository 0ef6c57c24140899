// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tour/ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.hpp"

namespace arcbid {

namespace {

/// Beyond this many sigma the Gaussian of eq. 13 is below 1.2 % and is taken as 0.
constexpr double kCutOffSigmas = 3.0;

}  // namespace

GrowingRing::GrowingRing(std::size_t neurons, const Vec3& centre, double radius) {
  check(neurons >= 3, "a ring has at least three neurons");
  for (std::size_t j = 0; j < neurons; ++j) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(neurons);
    insert(j, centre + radius * Vec3(std::cos(angle), std::sin(angle), 0), 0);
  }
}

std::size_t GrowingRing::winner(const Vec3& input) {
  const std::size_t neurons = size();
  const double x = input.x(), y = input.y(), z = input.z();
  for (std::size_t j = 0; j < neurons; ++j) {
    const double dx = x_[j] - x, dy = y_[j] - y, dz = z_[j] - z;
    squared_distance_[j] = dx * dx + dy * dy + dz * dz;
  }
  const auto nearest = std::min_element(squared_distance_.begin(), squared_distance_.end());
  return static_cast<std::size_t>(nearest - squared_distance_.begin());
}

void GrowingRing::pull(std::size_t winner, const Vec3& input, double eta, double sigma) {
  wins_[winner] += 1;
  move(winner, input, eta);
  // Half the ring on either side at most, so that no neuron is moved twice.
  const auto reach = static_cast<std::size_t>(
      std::min(kCutOffSigmas * sigma, static_cast<double>((size() - 1) / 2)));
  std::size_t after = winner, before = winner;
  for (std::size_t d = 1; d <= reach; ++d) {
    const double distance = static_cast<double>(d);
    const double h = std::exp(-distance * distance / (2 * sigma * sigma));  // Equation (13)
    after = next(after);
    before = previous(before);
    move(after, input, eta * h);
    move(before, input, eta * h);
  }
}

void GrowingRing::grow() {
  const auto most =
      static_cast<std::size_t>(std::max_element(wins_.begin(), wins_.end()) - wins_.begin());
  const Vec3 here = position(most);
  const Vec3 ahead = position(next(most)), behind = position(previous(most));
  const bool goes_ahead = (ahead - here).squaredNorm() >= (behind - here).squaredNorm();
  wins_[most] /= 2;
  insert(goes_ahead ? most + 1 : most, 0.5 * (here + (goes_ahead ? ahead : behind)), wins_[most]);
}

double GrowingRing::along(std::size_t winner, const Vec3& input) const {
  return (input - position(winner)).dot(position(next(winner)) - position(previous(winner)));
}

void GrowingRing::insert(std::size_t at, const Vec3& position, double wins) {
  const auto offset = static_cast<std::ptrdiff_t>(at);
  x_.insert(x_.begin() + offset, position.x());
  y_.insert(y_.begin() + offset, position.y());
  z_.insert(z_.begin() + offset, position.z());
  wins_.insert(wins_.begin() + offset, wins);
  squared_distance_.push_back(0);
}

void GrowingRing::move(std::size_t neuron, const Vec3& input, double fraction) {  // Equation (14)
  x_[neuron] += fraction * (input.x() - x_[neuron]);
  y_[neuron] += fraction * (input.y() - y_[neuron]);
  z_[neuron] += fraction * (input.z() - z_[neuron]);
}

}  // namespace arcbid
