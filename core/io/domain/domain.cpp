// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/domain/domain.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.hpp"

namespace arcbid {

namespace {

constexpr std::uint32_t kPortBase = 7400, kDomainGain = 250, kParticipantGain = 2;
constexpr std::uint32_t kDiscoveryOffset = 10, kDataOffset = 11;
constexpr std::uint32_t kLastDomain = 231;  // the last one whose whole range is below 65536

/// Owns a descriptor.
class Socket {
 public:
  explicit Socket(int family) : fd_(socket(family, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    if (fd_ < 0)
      throw InputError("cannot open a socket: raise the limit on open files (ulimit -n)");
  }
  ~Socket() {
    if (fd_ >= 0) close(fd_);
  }
  Socket(Socket&& other) noexcept : fd_(other.release()) {}
  int get() const { return fd_; }
  int release() { return std::exchange(fd_, -1); }

 private:
  int fd_;
};

/// Binding without SO_REUSEADDR fails when anybody has the port, on whichever address.
bool port_is_free(std::uint32_t port) {
  const Socket probe(AF_INET);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  return bind(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool ports_are_free(std::uint32_t domain, std::uint32_t fleet_size) {
  for (std::uint32_t p = 0; p < participants_of(fleet_size); ++p)
    if (!port_is_free(discovery_port(domain, p)) || !port_is_free(data_port(domain, p)))
      return false;
  return true;
}

/// What holds the domain; none when somebody else has it.
std::optional<Socket> reserve(std::uint32_t domain) {
  Socket holder(AF_UNIX);
  const std::string name = fmt::format("arcbid-domain-{}", domain);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  // A name that starts with NUL is abstract: no file, gone with its holder.
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(holder.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0)
    return std::nullopt;
  return holder;
}

/// Domains to try, in order: those outside the ephemeral port range, then the rest.
std::vector<std::uint32_t> candidates() {
  std::uint32_t low = 32768, high = 60999;
  std::ifstream("/proc/sys/net/ipv4/ip_local_port_range") >> low >> high;
  std::vector<std::uint32_t> all;
  for (std::uint32_t domain = 1; domain <= kLastDomain; ++domain) all.push_back(domain);
  std::stable_partition(all.begin(), all.end(), [&](std::uint32_t domain) {
    const std::uint32_t first = kPortBase + kDomainGain * domain;
    return first + kDomainGain <= low || first > high;
  });
  return all;
}

}  // namespace

std::uint32_t discovery_port(std::uint32_t domain, std::uint32_t participant) {
  return kPortBase + kDomainGain * domain + kDiscoveryOffset + kParticipantGain * participant;
}

std::uint32_t data_port(std::uint32_t domain, std::uint32_t participant) {
  return kPortBase + kDomainGain * domain + kDataOffset + kParticipantGain * participant;
}

DomainLease::DomainLease(std::uint32_t fleet_size) {
  if (fleet_size > kMaxFleetOfDomain)
    throw InputError(fmt::format("a fleet of {} does not fit one DDS domain's ports; at most {} do",
                                 fleet_size, kMaxFleetOfDomain));
  for (const std::uint32_t domain : candidates()) {
    std::optional<Socket> holder = reserve(domain);
    if (!holder || !ports_are_free(domain, fleet_size)) continue;
    domain_ = domain;
    reservation_ = holder->release();
    return;
  }
  throw InputError(fmt::format(
      "no DDS domain in 1..{} is free: other runs hold them or their UDP ports; end some",
      kLastDomain));
}

DomainLease::~DomainLease() {
  if (reservation_ >= 0) close(reservation_);
}

DomainLease::DomainLease(DomainLease&& other) noexcept
    : domain_(other.domain_), reservation_(std::exchange(other.reservation_, -1)) {}

DomainLease& DomainLease::operator=(DomainLease&& other) noexcept {
  std::swap(domain_, other.domain_);
  std::swap(reservation_, other.reservation_);
  return *this;
}

}  // namespace arcbid
