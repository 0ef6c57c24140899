// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/faulty_transport.hpp"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>

#include <utility>
#include <vector>

#include "core/io/process/process.hpp"
#include "idl/delay_line.hpp"

namespace arcbid {
namespace {

namespace fastdds = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

class FaultyTransport : public fastdds::ChainingTransport {
 public:
  explicit FaultyTransport(const FaultyTransportDescriptor& descriptor)
      : ChainingTransport(descriptor), faults_(descriptor.faults) {}

  fastdds::TransportDescriptorInterface* get_configuration() override {
    return low_level_transport_->get_configuration();
  }

  bool send(rtps::SenderResource* udp, const rtps::octet* packet, std::uint32_t size,
            rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
            const std::chrono::steady_clock::time_point& deadline) override {
    return udp->send(packet, size, first, last, deadline);
  }

  void receive(fastdds::TransportReceiverInterface* dds, const rtps::octet* packet,
               std::uint32_t size, const rtps::Locator_t& local,
               const rtps::Locator_t& remote) override {
    const TimeNs now_ns = monotonic_ns();
    for (const TimeNs at_ns : faults_->arrivals_ns({packet, size}, now_ns)) {
      if (at_ns <= now_ns) {
        dds->OnDataReceived(packet, size, local, remote);
        continue;
      }
      // The buffer is the channel's, which receives into it again once this returns.
      std::vector<rtps::octet> kept(packet, packet + size);
      late_.put(at_ns, [dds, kept = std::move(kept), local, remote] {
        dds->OnDataReceived(kept.data(), static_cast<std::uint32_t>(kept.size()), local, remote);
      });
    }
  }

  /// A participant closes its channels when it goes, and all of them. What receives behind them
  /// goes next, so nothing may be on its way there any more.
  bool CloseInputChannel(const rtps::Locator_t& channel) override {
    late_.stop();
    return ChainingTransport::CloseInputChannel(channel);
  }

 private:
  std::shared_ptr<PacketFaults> faults_;
  DelayLine late_;
};

}  // namespace

FaultyTransportDescriptor::FaultyTransportDescriptor(
    std::shared_ptr<fastdds::UDPv4TransportDescriptor> udp, std::shared_ptr<PacketFaults> faults_)
    : ChainingTransportDescriptor(std::move(udp)), faults(std::move(faults_)) {}

fastdds::TransportInterface* FaultyTransportDescriptor::create_transport() const {
  return new FaultyTransport(*this);
}

}  // namespace arcbid
