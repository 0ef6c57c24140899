// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/domain/domain.hpp"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>
#include <utility>
#include <vector>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

TEST(Domain, PortsFollowTheRtpsFormula) {
  EXPECT_EQ(discovery_port(0, 0), 7410u);
  EXPECT_EQ(data_port(0, 0), 7411u);
  EXPECT_EQ(discovery_port(3, 5), 7400u + 750 + 10 + 10);
  EXPECT_EQ(data_port(100, 1), 7400u + 25000 + 11 + 2);
}

TEST(Domain, APortOfTheLargestFleetStaysInItsDomain) {
  EXPECT_LT(data_port(1, participants_of(kMaxFleetOfDomain) - 1), 7400u + 2 * 250);
}

TEST(Domain, LeasesOfOneProcessDiffer) {
  std::vector<DomainLease> leases;
  std::set<std::uint32_t> domains;
  for (int i = 0; i < 5; ++i) domains.insert(leases.emplace_back(4).domain());
  EXPECT_EQ(domains.size(), 5u);
  EXPECT_EQ(domains.count(0), 0u);
}

TEST(Domain, AReleasedDomainCanBeLeasedAgain) {
  std::set<std::uint32_t> seen;
  for (int i = 0; i < 300; ++i) seen.insert(DomainLease(1).domain());
  EXPECT_LT(seen.size(), 231u);  // leaked reservations would have used them all up
}

TEST(Domain, MovingKeepsTheReservation) {
  DomainLease first(4);
  const std::uint32_t domain = first.domain();
  DomainLease moved(std::move(first));
  EXPECT_EQ(moved.domain(), domain);
  EXPECT_NE(DomainLease(4).domain(), domain);
}

/// A child that leases a domain, tells it, and holds it until it is killed.
std::pair<pid_t, std::uint32_t> holder() {
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return {-1, 0};
  const pid_t child = fork();
  if (child == 0) {
    const DomainLease lease(4);
    const std::uint32_t domain = lease.domain();
    if (write(pipe_ends[1], &domain, sizeof domain) != sizeof domain) _exit(1);
    pause();
    _exit(0);
  }
  std::uint32_t domain = 0;
  if (read(pipe_ends[0], &domain, sizeof domain) != sizeof domain) domain = 0;
  close(pipe_ends[0]);
  close(pipe_ends[1]);
  return {child, domain};
}

TEST(Domain, ExclusiveBetweenProcessesAndFreedByKill) {
  const auto [child, domain] = holder();
  ASSERT_GT(child, 0);
  ASSERT_NE(domain, 0u);
  {
    std::vector<DomainLease> leases;
    for (int i = 0; i < 20; ++i) EXPECT_NE(leases.emplace_back(4).domain(), domain);
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  std::vector<DomainLease> leases;
  bool again = false;  // domains are tried in order, so it comes up unless a parallel run has it
  for (int i = 0; i < 150 && !again; ++i) again = leases.emplace_back(4).domain() == domain;
  EXPECT_TRUE(again);
}

TEST(Domain, ADomainWhoseLastPortIsInUseIsPassedOver) {
  std::uint32_t domain = 0;
  {
    const DomainLease lease(4);
    domain = lease.domain();
  }
  const int squatter = socket(AF_INET, SOCK_DGRAM, 0);
  const int on = 1;  // as DDS implementations open theirs
  setsockopt(squatter, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(data_port(domain, participants_of(4) - 1)));
  ASSERT_EQ(bind(squatter, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_NE(DomainLease(4).domain(), domain);
  close(squatter);
}

TEST(Domain, AFleetTooLargeForADomainIsRefused) {
  EXPECT_THROW(DomainLease(kMaxFleetOfDomain + 1), InputError);
  EXPECT_NO_THROW(DomainLease{kMaxFleetOfDomain});
}

}  // namespace
}  // namespace arcbid
