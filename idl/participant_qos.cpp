// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/participant_qos.hpp"

#include <arpa/inet.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fmt/ranges.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/error.hpp"
#include "core/io/domain/domain.hpp"
#include "idl/faulty_transport.hpp"
#include "idl/guid_prefix.hpp"

namespace arcbid {

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

constexpr std::string_view kAgentRole = "arcbid/agent", kCoordinatorRole = "arcbid/coordinator";
constexpr std::size_t longest_name = 255;  // Fast DDS cuts off the rest without a word
constexpr std::uint32_t kSocketBuffer = 4 << 20;
// Server 0 as `fast-discovery-server -i 0` announces itself.
constexpr const char* kServerPrefix = "44.53.00.5f.45.50.52.4f.53.49.4d.41";
constexpr std::int32_t kLatchedBytesPerPeriod = 1 << 20;
constexpr std::uint64_t kLatchedPeriod_ms = 5;
constexpr const char* kLatchedFlow = "arcbid-latched";

in_addr ipv4(const std::string& address, const char* field) {
  in_addr parsed{};
  if (inet_pton(AF_INET, address.c_str(), &parsed) != 1)
    throw InputError(
        fmt::format("{}: '{}' is not an IPv4 address such as 127.0.0.1", field, address));
  return parsed;
}

/// Fast DDS takes a foreign address without a word and then hears nothing.
void require_own_address(const std::string& address) {
  sockaddr_in local{};
  local.sin_family = AF_INET;
  local.sin_addr = ipv4(address, "network.interface_address");
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool ours = local.sin_addr.s_addr != htonl(INADDR_ANY) &&
                    bind(probe, reinterpret_cast<const sockaddr*>(&local), sizeof local) == 0;
  if (probe >= 0) close(probe);
  if (!ours)
    throw InputError(fmt::format(
        "network.interface_address: {} is not the address of an interface of this machine (see "
        "'ip -4 address'); 127.0.0.1 always is",
        address));
}

/// Port 0 in an initial peer stands for all discovery ports of the domain.
rtps::Locator_t locator(const std::string& address, std::uint32_t port) {
  rtps::Locator_t out;
  rtps::IPLocator::setIPv4(out, address);
  out.port = port;
  return out;
}

void add_transport(dds::DomainParticipantQos& qos, const std::string& address,
                   std::uint32_t participants, std::shared_ptr<PacketFaults> faults) {
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {address};
  udp->sendBufferSize = udp->receiveBufferSize = kSocketBuffer;
  udp->maxInitialPeersRange = participants;
  qos.transport().use_builtin_transports = false;
  if (faults)
    qos.transport().user_transports.push_back(
        std::make_shared<FaultyTransportDescriptor>(udp, std::move(faults)));
  else
    qos.transport().user_transports.push_back(udp);
}

/// The name ends in the ids of the agents that share the participant: "arcbid-agent-1,2,3".
std::string name_of(const std::vector<AgentId>& agents) {
  if (agents.empty()) return "arcbid-coordinator";
  std::vector<std::uint32_t> ids;
  for (const AgentId agent : agents) ids.push_back(agent.value);
  const std::string name = fmt::format("arcbid-agent-{}", fmt::join(ids, ","));
  if (name.size() > longest_name)
    throw InputError(fmt::format(
        "{} agents in one process: their ids take {} characters, and a participant's name has {}; "
        "lower fleet.agents_per_process",
        ids.size(), name.size(), longest_name));
  return name;
}

void set_identity(dds::DomainParticipantQos& qos, const std::vector<AgentId>& agents,
                  const std::string& address) {
  qos.name(name_of(agents));
  const std::string_view role = agents.empty() ? kCoordinatorRole : kAgentRole;
  qos.user_data().setValue({role.begin(), role.end()});
  std::optional<AgentId> first;
  if (!agents.empty()) first = agents.front();
  const GuidPrefix prefix = new_guid_prefix(first, address);
  std::copy(prefix.begin(), prefix.end(), qos.wire_protocol().prefix.value);
}

void use_server(rtps::DiscoverySettings& discovery, const NetworkConfig& network) {
  ipv4(network.server_address, "network.server_address");
  eprosima::fastdds::rtps::RemoteServerAttributes server;
  server.ReadguidPrefix(kServerPrefix);
  server.metatrafficUnicastLocatorList.push_back(
      locator(network.server_address, network.server_port));
  discovery.discoveryProtocol = rtps::DiscoveryProtocol_t::CLIENT;
  discovery.m_DiscoveryServers.push_back(server);
}

/// The first participant's ports; where somebody has them, Fast DDS tries the next participant's.
/// Left to itself it starts at the number of participants this process ever made, which in the end
/// leaves the ports where others look. Naming a unicast locator also keeps it from adding the
/// multicast group.
void set_ports(dds::DomainParticipantQos& qos, const NetworkConfig& network, std::uint32_t domain,
               std::uint32_t participants) {
  qos.wire_protocol().builtin.metatrafficUnicastLocatorList.push_back(
      locator(network.interface_address, discovery_port(domain, 0)));
  qos.wire_protocol().default_unicast_locator_list.push_back(
      locator(network.interface_address, data_port(domain, 0)));
  qos.wire_protocol().builtin.mutation_tries = participants - 1;
}

void set_discovery(dds::DomainParticipantQos& qos, const NetworkConfig& network) {
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  // Liveliness is the auction's own business (relayed heartbeats), and nothing asks DDS for it.
  builtin.use_WriterLivelinessProtocol = false;
  // Sooner than the default 20 s, later than any pause of a busy machine.
  builtin.discovery_config.leaseDuration = Duration_t(10, 0);
  builtin.discovery_config.leaseDuration_announcementperiod = Duration_t(2, 0);
  if (network.transport == TransportKind::discovery_server)
    use_server(builtin.discovery_config, network);
  else
    builtin.initialPeersList.push_back(locator(network.interface_address, 0));
}

bool reliable(Delivery delivery, const NetworkConfig& network) {
  return delivery == Delivery::latched || (delivery == Delivery::bids && network.reliable_bids);
}

/// What writers and readers have in common. One sample an instance is kept: every message is whole,
/// and the newest is the only one that counts.
template <class Qos>
Qos endpoint_qos(Delivery delivery, const NetworkConfig& network) {
  Qos qos;
  const bool sure = reliable(delivery, network);
  qos.reliability().kind = sure ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = sure ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 1;
  // 0: no limit. The defaults stop at 10 instances, which a fleet of 11 fills.
  qos.resource_limits().max_samples = 0;
  qos.resource_limits().max_instances = 0;
  qos.resource_limits().max_samples_per_instance = 0;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  // Shared memory, which would leave files behind in /dev/shm.
  qos.data_sharing().off();
  return qos;
}

}  // namespace

dds::DomainParticipantQos participant_qos(const NetworkConfig& network, std::uint32_t domain,
                                          const BusMember& member, std::uint32_t fleet_size,
                                          std::shared_ptr<PacketFaults> faults) {
  require_own_address(network.interface_address);
  const std::uint32_t participants = participants_of(fleet_size);
  dds::DomainParticipantQos qos;
  set_identity(qos, member.agents, network.interface_address);
  add_transport(qos, network.interface_address, participants, std::move(faults));
  set_ports(qos, network, domain, participants);
  set_discovery(qos, network);
  auto flow = std::make_shared<eprosima::fastdds::rtps::FlowControllerDescriptor>();
  flow->name = kLatchedFlow;
  flow->max_bytes_per_period = kLatchedBytesPerPeriod;
  flow->period_ms = kLatchedPeriod_ms;
  qos.flow_controllers().push_back(flow);
  return qos;
}

bool is_agent(const std::vector<std::uint8_t>& user_data) {
  return std::string_view(reinterpret_cast<const char*>(user_data.data()), user_data.size()) ==
         kAgentRole;
}

dds::DataWriterQos writer_qos(Delivery delivery, const NetworkConfig& network) {
  auto qos = endpoint_qos<dds::DataWriterQos>(delivery, network);
  // The default 3 s would let a lost sample wait that long to be noticed.
  qos.reliable_writer_qos().times.heartbeatPeriod = Duration_t(0, 100'000'000);
  if (delivery == Delivery::latched) {
    // Several MB to a whole fleet at once would overrun the receivers' socket buffers.
    qos.publish_mode().kind = dds::ASYNCHRONOUS_PUBLISH_MODE;
    qos.publish_mode().flow_controller_name = kLatchedFlow;
  }
  return qos;
}

dds::DataReaderQos reader_qos(Delivery delivery, const NetworkConfig& network) {
  return endpoint_qos<dds::DataReaderQos>(delivery, network);
}

}  // namespace arcbid
