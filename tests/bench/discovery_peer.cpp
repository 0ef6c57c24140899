// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/discovery_peer.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <memory>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/io/domain/domain.hpp"
#include "core/io/process/process.hpp"
#include "idl/participant_qos.hpp"
#include "idl/topics.hpp"

namespace arcbid::bench {

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kServerPrefix = "44.53.00.5f.45.50.52.4f.53.49.4d.41";
constexpr std::uint32_t kServerIndex = 119;  // behind the ports of the largest fleet

struct TopicUse {
  const char* name;
  Delivery delivery;
  bool writes, reads;
};

/// The first is the one whose matches are counted.
std::vector<TopicUse> topics_of(const Way& way) {
  // Latched kinds on a topic that all write and read would cost acknowledgements as well; without
  // them the figure is the least that fewer topics can cost.
  if (way.two_topics)
    return {{"bench/statements", Delivery::bids, true, true},
            {"bench/status", Delivery::periodic, true, true}};
  return {{"bench/bids", Delivery::bids, true, true},
          {"bench/relays", Delivery::bids, true, true},
          {"bench/status", Delivery::periodic, true, true},
          {"bench/routes", Delivery::latched, true, false},
          {"bench/mission", Delivery::latched, false, true},
          {"bench/control", Delivery::latched, false, true}};
}

rtps::Locator_t locator(std::uint32_t port) {
  rtps::Locator_t out;
  rtps::IPLocator::setIPv4(out, kLoopback);
  out.port = port;
  return out;
}

std::string static_name(std::uint32_t index) {
  return fmt::format("process-{}", index);
}

/// Static discovery's ids are distinct over all endpoints of all participants: Fast DDS 2.9 keeps
/// one set for the whole file and leaves out what repeats.
std::int16_t static_id(std::uint32_t index, std::uint32_t topics, std::uint32_t topic,
                       bool reader) {
  return static_cast<std::int16_t>(1 + 2 * (index * topics + topic) + (reader ? 1 : 0));
}

std::string static_file(const Way& way, const Fleet& fleet, const std::string& type) {
  const std::vector<TopicUse> topics = topics_of(way);
  const auto count = static_cast<std::uint32_t>(topics.size());
  std::string xml = "data://<?xml version=\"1.0\" encoding=\"utf-8\"?><staticdiscovery>";
  for (std::uint32_t p = 0; p < fleet.processes(); ++p) {
    xml += fmt::format("<participant><name>{}</name>", static_name(p));
    for (std::uint32_t t = 0; t < count; ++t)
      for (const bool reader : {false, true})
        xml += fmt::format(
            "<{0}><userId>{1}</userId><topicName>{2}</topicName><topicDataType>{3}</topicDataType>"
            "<topicKind>WITH_KEY</topicKind>"
            "<reliabilityQos>BEST_EFFORT_RELIABILITY_QOS</reliabilityQos>"
            "<durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos></{0}>",
            reader ? "reader" : "writer", static_id(p, count, t, reader), topics[t].name, type);
    xml += "</participant>";
  }
  return xml + "</staticdiscovery>";
}

std::vector<AgentId> agents_of(const Fleet& fleet, std::uint32_t index) {
  std::vector<AgentId> agents;
  const std::uint32_t first = index * fleet.agents_per_process;
  const std::uint32_t end = std::min(fleet.agents, first + fleet.agents_per_process);
  for (std::uint32_t k = first; k < end; ++k) agents.push_back({k + 1});
  return agents;
}

/// A port of one's own by index, for only then is it known whose are below.
void announce_below(dds::DomainParticipantQos& qos, const Fleet& fleet, std::uint32_t index) {
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  builtin.metatrafficUnicastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList.push_back(locator(discovery_port(fleet.domain, index)));
  qos.wire_protocol().default_unicast_locator_list.clear();
  qos.wire_protocol().default_unicast_locator_list.push_back(
      locator(data_port(fleet.domain, index)));
  builtin.initialPeersList.clear();
  // The lowest announces itself to itself: with no peers at all Fast DDS would take multicast.
  for (std::uint32_t p = 0; p < std::max(index, 1u); ++p)
    builtin.initialPeersList.push_back(locator(discovery_port(fleet.domain, p)));
}

/// The fleet's settings, changed where the way asks for it.
dds::DomainParticipantQos qos_of(const Way& way, const Fleet& fleet, std::uint32_t index,
                                 const std::string& type) {
  NetworkConfig network;
  if (way.meeting == Meeting::server) network.transport = TransportKind::discovery_server;
  network.server_port = static_cast<std::uint16_t>(data_port(fleet.domain, kServerIndex));
  auto qos = participant_qos(network, fleet.domain, agents_of(fleet, index), fleet.agents);
  if (way.meeting == Meeting::those_below) announce_below(qos, fleet, index);
  if (way.static_endpoints) {
    check(way.two_topics, "the file describes topics that all write and read");
    qos.name(static_name(index));
    auto& discovery = qos.wire_protocol().builtin.discovery_config;
    discovery.use_SIMPLE_EndpointDiscoveryProtocol = false;
    discovery.use_STATIC_EndpointDiscoveryProtocol = true;
    discovery.static_edp_xml_config(static_file(way, fleet, type).c_str());
  }
  return qos;
}

/// Whose writer and whose reader of the first topic are matched, the process's own aside.
class Matches : public dds::DataWriterListener, public dds::DataReaderListener {
 public:
  void on_publication_matched(dds::DataWriter* writer,
                              const dds::PublicationMatchedStatus& status) override {
    note(readers_, writer->guid(), status.last_subscription_handle, status.current_count_change);
  }

  void on_subscription_matched(dds::DataReader* reader,
                               const dds::SubscriptionMatchedStatus& status) override {
    note(writers_, reader->guid(), status.last_publication_handle, status.current_count_change);
  }

  bool reach(std::size_t others, TimeNs limit_ns) {
    std::unique_lock lock(mutex_);
    const std::chrono::nanoseconds left(limit_ns - monotonic_ns());
    return changed_.wait_for(
        lock, left, [&] { return writers_.size() == others && readers_.size() == others; });
  }

 private:
  using Prefixes = std::set<rtps::GuidPrefix_t>;

  void note(Prefixes& known, const rtps::GUID_t& own, const dds::InstanceHandle_t& handle,
            int change) {
    const rtps::GuidPrefix_t other = rtps::iHandle2GUID(handle).guidPrefix;
    if (other == own.guidPrefix) return;
    const std::scoped_lock lock(mutex_);
    if (change > 0)
      known.insert(other);
    else
      known.erase(other);
    changed_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Prefixes writers_, readers_;
};

/// For all topics: nothing is ever written, and discovery only sees the name.
dds::TypeSupport silent_type() {
  dds::TypeSupport type(new wire::BidsPubSubType());
  type->auto_fill_type_information(false);
  type->auto_fill_type_object(false);
  return type;
}

void open(dds::DomainParticipant& participant, const std::string& type,
          const std::vector<TopicUse>& topics, std::uint32_t index, Matches& matches) {
  dds::Publisher* publisher = participant.create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  dds::Subscriber* subscriber = participant.create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  const auto count = static_cast<std::uint32_t>(topics.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    dds::Topic* topic = participant.create_topic(topics[t].name, type, dds::TOPIC_QOS_DEFAULT);
    Matches* listener = t == 0 ? &matches : nullptr;
    if (topics[t].writes) {
      auto qos = writer_qos(topics[t].delivery, {});
      qos.endpoint().user_defined_id = static_id(index, count, t, false);
      check(publisher->create_datawriter(topic, qos, listener) != nullptr,
            "a writer's QoS is legal");
    }
    if (topics[t].reads) {
      auto qos = reader_qos(topics[t].delivery, {});
      qos.endpoint().user_defined_id = static_id(index, count, t, true);
      check(subscriber->create_datareader(topic, qos, listener) != nullptr,
            "a reader's QoS is legal");
    }
  }
}

}  // namespace

bool meet_all(const Way& way, const Fleet& fleet, std::uint32_t index, TimeNs limit_ns) {
  static Matches matches;  // called until the process ends
  dds::TypeSupport type = silent_type();
  dds::DomainParticipant* participant =
      dds::DomainParticipantFactory::get_instance()->create_participant(
          fleet.domain, qos_of(way, fleet, index, type.get_type_name()));
  if (participant == nullptr)
    throw RunError(fmt::format("Fast DDS refuses participant {} of domain {} ({})", index,
                               fleet.domain, way.name));
  type.register_type(participant);
  open(*participant, type.get_type_name(), topics_of(way), index, matches);
  return matches.reach(fleet.processes() - 1, limit_ns);
}

void start_discovery_server(const Fleet& fleet) {
  dds::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {kLoopback};
  udp->sendBufferSize = udp->receiveBufferSize = 4 << 20;  // as the fleet's
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  std::istringstream(kServerPrefix) >> qos.wire_protocol().prefix;
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  builtin.metatrafficUnicastLocatorList.push_back(locator(data_port(fleet.domain, kServerIndex)));
  builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol_t::SERVER;
  if (dds::DomainParticipantFactory::get_instance()->create_participant(fleet.domain, qos) ==
      nullptr)
    throw RunError(fmt::format("Fast DDS refuses the server of domain {}", fleet.domain));
}

}  // namespace arcbid::bench
