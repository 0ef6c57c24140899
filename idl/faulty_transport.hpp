// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <memory>

#include "idl/packet_faults.hpp"

namespace arcbid {

/// UDPv4 that loses, delays and repeats what it receives as `faults` say. It sends everything.
struct FaultyTransportDescriptor : eprosima::fastdds::rtps::ChainingTransportDescriptor {
  FaultyTransportDescriptor(
      std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp,
      std::shared_ptr<PacketFaults> faults);

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

  std::shared_ptr<PacketFaults> faults;
};

}  // namespace arcbid
