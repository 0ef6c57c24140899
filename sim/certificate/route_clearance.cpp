// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/route_clearance.hpp"

#include <algorithm>

#include "sim/certificate/parallel.hpp"

namespace arcbid::certificate {
namespace {

constexpr double farthest_m = 1e7;  // legs farther away than this are as good as infinitely far
constexpr double level_slack_m = 1e-6, tolerance_m = 1e-3;

void keep_nearer(Nearest& best, const Vec3& from, const Vec3& to, std::size_t leg,
                 const Distances& distances) {
  const double most_m = std::min(best.distance_m, farthest_m);
  const Approach found = distances.from(from, to, most_m);
  if (found.distance_m >= most_m) return;
  best = {found.distance_m, leg, from + found.along * (to - from)};
}

/// A straight piece of a leg; what is below the floor apart from what is not.
class Piece {
 public:
  Piece(const Vec3& from, const Vec3& to, double floor_m) : from_(from), to_(to) {
    const double below_from = floor_m - level_slack_m - from.z(),
                 below_to = floor_m - level_slack_m - to.z();
    begins_low_ = below_from > 0;
    ends_low_ = below_to > 0;
    if (begins_low_ != ends_low_)
      crossing_ = from + below_from / (below_from - below_to) * (to - from);
  }
  template <class Take>
  void split(const Take& take) const {
    if (begins_low_ == ends_low_) return take(from_, to_, begins_low_);
    take(from_, crossing_, begins_low_);
    take(crossing_, to_, ends_low_);
  }

 private:
  Vec3 from_, to_, crossing_ = Vec3::Zero();
  bool begins_low_ = false, ends_low_ = false;
};

/// Rising from home and landing there, straight up and down. All else is flight.
bool is_column(const Vec3& home, const Vec3& from, const Vec3& to) {
  const auto is_over_home = [&](const Vec3& p) {
    return (p - home).head<2>().norm() <= tolerance_m;
  };
  return is_over_home(from) && is_over_home(to);
}

AgentClearance clearance_of(const Flight& flight, const Distances& distances, double floor_m) {
  AgentClearance out;
  out.agent = flight.agent;
  for (std::size_t leg = 0; leg < flight.legs.size(); ++leg) {
    const Path& path = flight.legs[leg].waypoints;
    const bool is_transit = !flight.legs[leg].arc;
    const auto rises = [&](const Vec3& from, const Vec3& to) {
      return is_transit && leg == 0 && is_column(path.front().position_m, from, to);
    };
    const auto lands = [&](const Vec3& from, const Vec3& to) {
      return is_transit && leg + 1 == flight.legs.size() &&
             is_column(path.back().position_m, from, to);
    };
    for (std::size_t w = 1; w < path.size(); ++w)
      Piece(path[w - 1].position_m, path[w].position_m, floor_m)
          .split([&](const Vec3& from, const Vec3& to, bool is_low) {
            const bool is_home = is_low && (rises(from, to) || lands(from, to));
            if (is_low && !is_home) out.below_floor_m += (to - from).norm();
            keep_nearer(is_home ? out.home : out.flight, from, to, leg, distances);
          });
  }
  return out;
}

}  // namespace

std::vector<AgentClearance> clearances(const Flown& flown, const Distances& distances,
                                       double floor_m, unsigned threads) {
  std::vector<AgentClearance> all(flown.flights.size());
  in_chunks(all.size(), 1, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      all[f] = clearance_of(flown.flights[f], distances, floor_m);
  });
  return all;
}

}  // namespace arcbid::certificate
