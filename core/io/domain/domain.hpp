// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace arcbid {

/// The UDP port that participant number `participant` of a DDS domain uses; DDSI-RTPS 2.2, section
/// 9.6.1.1: PB + DG·domain + d + PG·participant with PB = 7400, DG = 250, PG = 2, d1 = 10
/// (discovery) and d3 = 11 (data). May exceed 65535 for numbers that are out of range.
std::uint32_t discovery_port(std::uint32_t domain, std::uint32_t participant);
std::uint32_t data_port(std::uint32_t domain, std::uint32_t participant);

/// How many participants a fleet's domain must have room for: the agents, the coordinator, and a
/// few that are on their way out or look on.
constexpr std::uint32_t participants_of(std::uint32_t fleet_size) {
  return fleet_size + 4;
}

/// The largest fleet whose participants' ports stay inside one domain's range of 250.
inline constexpr std::uint32_t kMaxFleetOfDomain = 115;

/// A DDS domain that no other run in this network namespace uses: no other living DomainLease holds
/// it (an abstract Unix socket, which the kernel frees when the holder ends, however it ends), and
/// when it was taken the ports of all participants of the fleet were free. Domains whose ports lie
/// outside the kernel's ephemeral port range go first; domain 0, everybody's default, is never
/// taken.
class DomainLease {
 public:
  /// Throws InputError when the fleet is larger than kMaxFleetOfDomain or no domain is free.
  explicit DomainLease(std::uint32_t fleet_size);
  ~DomainLease();
  DomainLease(DomainLease&& other) noexcept;
  DomainLease& operator=(DomainLease&& other) noexcept;

  std::uint32_t domain() const { return domain_; }

 private:
  std::uint32_t domain_ = 0;
  int reservation_ = -1;  ///< descriptor of the abstract socket; -1: moved from
};

}  // namespace arcbid
