// SPDX-License-Identifier: GPL-3.0-or-later
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include "tests/idl/bus_fixture.hpp"
#include "tests/idl/equal.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

/// What `fast-discovery-server -i 0 -l 127.0.0.1 -p PORT` runs.
dds::DomainParticipant* start_server(std::uint32_t domain, std::uint16_t port) {
  dds::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {"127.0.0.1"};
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  std::istringstream("44.53.00.5f.45.50.52.4f.53.49.4d.41") >> qos.wire_protocol().prefix;
  rtps::Locator_t locator;
  rtps::IPLocator::setIPv4(locator, "127.0.0.1");
  locator.port = port;
  qos.wire_protocol().builtin.metatrafficUnicastLocatorList.push_back(locator);
  qos.wire_protocol().builtin.discovery_config.discoveryProtocol =
      rtps::DiscoveryProtocol_t::SERVER;
  return dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos);
}

TEST_F(BusTest, FleetMeetsThroughADiscoveryServer) {
  // The last port of the domain's range: no participant of the fleet gets there.
  const auto port = static_cast<std::uint16_t>(data_port(lease_.domain(), 119));
  dds::DomainParticipant* server = start_server(lease_.domain(), port);
  ASSERT_NE(server, nullptr);
  network_.transport = TransportKind::discovery_server;
  network_.server_port = port;
  {
    const auto boss = coordinator(), one = agent(1);
    auto two = agent(2);
    EXPECT_TRUE(matched(*one, 1) && matched(*two, 1) && matched(*boss, 2));
    boss->publish(samples::mission());
    const auto got = next<Mission>(*two);
    ASSERT_TRUE(got);
    EXPECT_TRUE(same(*got, samples::mission()));
    two.reset();
    EXPECT_TRUE(matched(*one, 0) && matched(*boss, 1));
  }
  dds::DomainParticipantFactory::get_instance()->delete_participant(server);
}

}  // namespace
}  // namespace arcbid
