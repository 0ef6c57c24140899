// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <memory>

#include "core/io/config.hpp"
#include "idl/bus.hpp"
#include "idl/packet_faults.hpp"
#include "idl/topics.hpp"

namespace arcbid {

/// UDPv4 on one interface, unicast only, no shared memory, at the lowest of the domain's ports that
/// are free; peers found on those ports at the interface's address, or through a discovery server.
/// The role travels as the participant's user data, the agent's id in its name and in its GUID
/// prefix (idl/guid_prefix.hpp), which is another one in each call. With `faults`, they act on what
/// UDP receives. Throws InputError when an address isn't IPv4 or the interface isn't this
/// machine's.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(
    const NetworkConfig& network, std::uint32_t domain, const BusMember& member,
    std::uint32_t fleet_size, std::shared_ptr<PacketFaults> faults = nullptr);

/// True when a participant's user data says that it is an agent.
bool is_agent(const std::vector<std::uint8_t>& user_data);

eprosima::fastdds::dds::DataWriterQos writer_qos(Delivery delivery, const NetworkConfig& network);
eprosima::fastdds::dds::DataReaderQos reader_qos(Delivery delivery, const NetworkConfig& network);

}  // namespace arcbid
