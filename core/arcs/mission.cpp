// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/arcs/mission.hpp"

#include "core/base/digest.hpp"

namespace arcbid {

std::uint64_t digest(const Mission& mission) {
  Digest d;
  d.add(mission.id).add(std::string_view(mission.name)).add(digest(mission.arcs));
  for (const Uav& uav : mission.fleet) {
    d.add(std::uint64_t{uav.id.value}).add(uav.speed_mps);
    d.add(std::uint64_t{uav.endurance_s.has_value()}).add(uav.endurance_s.value_or(0));
    d.add(static_cast<std::uint64_t>(uav.payload));
    for (int axis = 0; axis < 3; ++axis) d.add(uav.home_m[axis]);
  }
  d.add(digest(mission.airspace));
  const AuctionSettings& a = mission.auction;
  d.add(static_cast<std::uint64_t>(a.policy)).add(static_cast<std::uint64_t>(a.score));
  d.add(a.discount_per_s).add(std::uint64_t{a.split_m.has_value()}).add(a.split_m.value_or(0));
  d.add(std::uint64_t{a.max_tasks}).add(std::uint64_t{a.bundle_limit});
  d.add(static_cast<std::uint64_t>(a.trades)).add(std::uint64_t{a.audit_bids});
  for (const TimeNs ns : {a.tick_ns, a.lease_ns, a.barrier_ns})
    d.add(static_cast<std::uint64_t>(ns));
  const TourSettings& t = mission.tour;
  d.add(static_cast<std::uint64_t>(t.solver)).add(t.seed);
  d.add(std::uint64_t{t.epochs}).add(std::uint64_t{t.iterations});
  return d.value();
}

}  // namespace arcbid
