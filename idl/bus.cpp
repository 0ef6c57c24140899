// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/bus.hpp"

#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <mutex>
#include <sstream>
#include <tuple>
#include <utility>

#include "core/base/error.hpp"
#include "core/io/domain/domain.hpp"
#include "idl/endpoint.hpp"
#include "idl/packet_faults.hpp"
#include "idl/participant_qos.hpp"

namespace arcbid {

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr std::uint32_t kLastDomain = 231;

/// The ids in a participant's name: "arcbid-agent-1,2,3" has three.
std::vector<std::string> agents_of(const std::string& name) {
  std::vector<std::string> ids;
  std::istringstream list(name.substr(name.rfind('-') + 1));
  for (std::string id; std::getline(list, id, ',');) ids.push_back(id);
  return ids;
}

/// Learns which participants are agents.
class RoleListener : public dds::DomainParticipantListener {
 public:
  explicit RoleListener(PeerTable& peers) : peers_(peers) {}

  void on_participant_discovery(dds::DomainParticipant*,
                                rtps::ParticipantDiscoveryInfo&& found) override {
    using Info = rtps::ParticipantDiscoveryInfo;
    const bool here = found.status == Info::DISCOVERED_PARTICIPANT ||
                      found.status == Info::CHANGED_QOS_PARTICIPANT;
    std::vector<std::string> agents;
    if (here && is_agent(found.info.m_userData))
      agents = agents_of(found.info.m_participantName.to_string());
    peers_.set_agents(found.info.m_guid.guidPrefix, std::move(agents));
  }

 private:
  PeerTable& peers_;
};

/// Buses of one process talk over the network as those of several do: what tests see is what runs.
void turn_off_intraprocess_delivery() {
  static std::once_flag once;
  std::call_once(once, [] {
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  });
}

/// What this process does on a topic, and whether its matches there are counted as peers.
struct Use {
  bool writes = false, reads = false;
  bool counts_writers = false, counts_readers = false;
};

template <class Message>
struct Endpoint {
  std::unique_ptr<Listener<Message>> listener;
  dds::DataWriter* writer = nullptr;  ///< null: this member doesn't write the topic
  dds::DataReader* reader = nullptr;
};

}  // namespace

struct Bus::Impl {
  Impl(const NetworkConfig& network, std::uint32_t domain, const BusMember& member,
       std::uint32_t fleet_size, FaultTier tier)
      : self(member), roles(reception.peers) {
    if (domain > kLastDomain)
      throw InputError(
          fmt::format("network.domain: {} is not a DDS domain; 0..{} are", domain, kLastDomain));
    turn_off_intraprocess_delivery();
    if (tier == FaultTier::packets) packet_faults = std::make_shared<PacketFaults>();
    const auto qos = participant_qos(network, domain, member, fleet_size, packet_faults);
    participant = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, qos, &roles, dds::StatusMask::none());
    if (participant == nullptr)
      throw InputError(fmt::format(
          "network: cannot join DDS domain {} at {}: more than {} participants, or its UDP ports "
          "from {} on are taken",
          domain, network.interface_address, participants_of(fleet_size),
          discovery_port(domain, 0)));
    publisher = participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber = participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    check(publisher != nullptr && subscriber != nullptr, "a participant has a publisher");
    const bool agent = !member.agents.empty();
    open<Mission>(network, {.writes = !agent, .reads = agent, .counts_readers = !agent});
    open<ControlMessage>(network, {.writes = !agent, .reads = agent});
    open<BidMessage>(network, {agent, agent, agent, agent});
    open<RelayMessage>(network, {.writes = agent, .reads = agent});
    open<StatusMessage>(network, {.writes = agent, .reads = true, .counts_writers = !agent});
    open<RouteMessage>(network, {.writes = agent, .reads = !agent});
  }

  ~Impl() {
    if (participant == nullptr) return;
    // No callback starts after this, and deleting an endpoint waits for one in progress; the
    // listeners themselves go last, with the members.
    participant->set_listener(nullptr);
    std::apply([](auto&... endpoint) { (silence(endpoint), ...); }, endpoints);
    participant->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }

  template <class Message>
  void open(const NetworkConfig& network, const Use& use) {
    if (!use.writes && !use.reads) return;
    using About = arcbid::Topic<Message>;
    dds::TypeSupport type(new GuardedType<typename About::Type>());
    type->auto_fill_type_information(false);
    type->auto_fill_type_object(false);
    type.register_type(participant);
    dds::Topic* topic =
        participant->create_topic(About::name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    check(topic != nullptr, "topics are created once");
    auto& endpoint = std::get<Endpoint<Message>>(endpoints);
    endpoint.listener =
        std::make_unique<Listener<Message>>(reception, use.counts_writers, use.counts_readers);
    if (use.writes) {
      endpoint.writer = publisher->create_datawriter(topic, writer_qos(About::delivery, network),
                                                     endpoint.listener.get());
      check(endpoint.writer != nullptr, "the writer's QoS is consistent");
    }
    if (use.reads) {
      endpoint.reader = subscriber->create_datareader(topic, reader_qos(About::delivery, network),
                                                      endpoint.listener.get());
      check(endpoint.reader != nullptr, "the reader's QoS is consistent");
    }
  }

  template <class Message>
  static void silence(Endpoint<Message>& endpoint) {
    if (endpoint.writer != nullptr) endpoint.writer->set_listener(nullptr);
    if (endpoint.reader != nullptr) endpoint.reader->set_listener(nullptr);
  }

  template <class Message>
  void publish(const Message& message) {
    dds::DataWriter* writer = std::get<Endpoint<Message>>(endpoints).writer;
    check(writer != nullptr, "this member writes the topic");
    auto sample = to_wire(message);
    // False: the sample could not be stored or handed on. It may as well have been lost on the way.
    if (!writer->write(&sample)) {
      ++reception.counters.dropped;
      return;
    }
    ++reception.counters.sent;
    reception.counters.bytes_sent += decltype(sample)::getCdrSerializedSize(sample);
  }

  const BusMember self;
  std::shared_ptr<PacketFaults> packet_faults;  ///< the transport's too; null: plain UDP
  Reception reception;
  RoleListener roles;
  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  std::tuple<Endpoint<Mission>, Endpoint<ControlMessage>, Endpoint<BidMessage>,
             Endpoint<RelayMessage>, Endpoint<StatusMessage>, Endpoint<RouteMessage>>
      endpoints;
};

Bus::Bus(const NetworkConfig& network, std::uint32_t domain, const BusMember& member,
         std::uint32_t fleet_size, FaultTier tier)
    : impl_(std::make_unique<Impl>(network, domain, member, fleet_size, tier)) {}

Bus::~Bus() = default;

void Bus::publish(const Mission& mission) {
  impl_->publish(mission);
}
void Bus::publish(const ControlMessage& message) {
  impl_->publish(message);
}
void Bus::publish(const BidMessage& message) {
  impl_->publish(message);
}
void Bus::publish(const RelayMessage& message) {
  impl_->publish(message);
}
void Bus::publish(const StatusMessage& message) {
  impl_->publish(message);
}
void Bus::publish(const RouteMessage& message) {
  impl_->publish(message);
}

std::vector<Received> Bus::wait(std::chrono::nanoseconds timeout) {
  return impl_->reception.inbox.take(timeout);
}

void Bus::wake() {
  impl_->reception.inbox.wake();
}

std::uint32_t Bus::matched_agents() const {
  return impl_->reception.peers.matched_agents();
}

TrafficCounters Bus::counters() const {
  const AtomicCounters& now = impl_->reception.counters;
  return {now.sent, now.received, now.dropped, now.bytes_sent};
}

void Bus::set_packet_faults(const FaultSchedule& schedule, const std::vector<Uav>& fleet,
                            TimeNs epoch_ns) {
  check(!impl_->self.agents.empty() && impl_->packet_faults,
        "packet faults are an agent's, of tier packets");
  impl_->packet_faults->install(schedule, fleet, impl_->self.agents.front(), epoch_ns);
}

std::map<AgentId, LinkCounters> Bus::packet_counters() const {
  return impl_->packet_faults ? impl_->packet_faults->counters()
                              : std::map<AgentId, LinkCounters>{};
}

}  // namespace arcbid
