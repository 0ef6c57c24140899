// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <random>

#include "idl/convert.hpp"
#include "idl/participant_qos.hpp"
#include "tests/idl/bus_fixture.hpp"
#include "tests/idl/equal.hpp"
#include "tests/idl/samples.hpp"

namespace arcbid {
namespace {

namespace dds = eprosima::fastdds::dds;
using Bytes = std::vector<std::uint8_t>;

/// The generated type by name and key, but what goes out is whatever bytes are set.
template <class Generated>
class RawType : public Generated {
 public:
  Bytes bytes;
  bool serialize(void*, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
    payload->encapsulation = CDR_LE;
    std::copy(bytes.begin(), bytes.end(), payload->data);
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [this] { return static_cast<std::uint32_t>(bytes.size()); };
  }
};

/// A participant of our own making that writes one topic, below all checks of the bus.
template <class Message>
class Intruder {
 public:
  using Sample = typename Topic<Message>::Type::type;

  Intruder(const NetworkConfig& network, std::uint32_t domain)
      : raw_(new RawType<typename Topic<Message>::Type>()), type_(raw_) {
    participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, participant_qos(network, domain, the_coordinator, 16));
    type_.register_type(participant_);
    dds::Topic* topic = participant_->create_topic(Topic<Message>::name, type_.get_type_name(),
                                                   dds::TOPIC_QOS_DEFAULT);
    dds::Publisher* publisher = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    dds::DataWriterQos qos = writer_qos(Delivery::latched, network);
    qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;  // every single one must arrive
    writer_ = publisher->create_datawriter(topic, qos);
  }
  ~Intruder() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }

  static Bytes bytes_of(Sample sample) {
    typename Topic<Message>::Type honest;
    eprosima::fastrtps::rtps::SerializedPayload_t payload(
        honest.getSerializedSizeProvider(&sample)());
    EXPECT_TRUE(honest.serialize(&sample, &payload));
    return Bytes(payload.data, payload.data + payload.length);
  }
  bool matched() const {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count == 1;
  }
  void write(Sample sample) { write(bytes_of(sample), sample); }
  void write(Bytes bytes, Sample key = {}) {
    raw_->bytes = std::move(bytes);
    ASSERT_TRUE(writer_->write(&key));
  }

 private:
  RawType<typename Topic<Message>::Type>* raw_;  // owned by type_
  dds::TypeSupport type_;
  dds::DomainParticipant* participant_;
  dds::DataWriter* writer_;
};

/// Where a Bids payload says what its statement's body is: encapsulation (4), header (40), sender
/// (4 and 4 of padding), incarnation (8), dead and version (8).
constexpr std::size_t kBodyKindAt = 68;

/// Reasons of `count` refused samples, sorted.
std::vector<std::string> refusals(Bus& bus, std::size_t count) {
  std::vector<std::string> reasons;
  const auto deadline = Clock::now() + 10s;
  while (reasons.size() < count && Clock::now() < deadline)
    for (const Received& received : bus.wait(deadline - Clock::now()))
      if (const auto* bad = std::get_if<Malformed>(&received)) reasons.push_back(bad->reason);
  std::sort(reasons.begin(), reasons.end());
  return reasons;
}

/// A writer knows its reader before the reader knows it, and a best-effort sample that is written
/// in between is lost: writes garbage until some arrives. Returns how many samples were counted.
template <class Message>
std::uint64_t meet(Bus& victim, Intruder<Message>& intruder) {
  const auto counted = [&] { return victim.counters().dropped; };
  EXPECT_TRUE(BusTest::eventually([&] {
    if (intruder.matched() && counted() == 0) intruder.write(Bytes{0});
    return counted() > 0;
  }));
  for (std::uint64_t before = 0; before != counted();) {
    before = counted();
    std::this_thread::sleep_for(50ms);
  }
  victim.wait(0ms);
  return counted();
}

TEST_F(BusTest, MalformedBidsAreCountedReportedAndSurvived) {
  const auto victim = agent(1);
  Intruder<BidMessage> intruder(network_, lease_.domain());
  const std::uint64_t before = meet(*victim, intruder);

  wire::Bids sample = to_wire(samples::bids(2));
  sample.header().schema_version(9);
  intruder.write(sample);
  BidMessage nan = samples::bids(2);
  std::get<Claims>(nan.statement.body).bundle[0].bid = std::nan("");
  intruder.write(to_wire(nan));
  Bytes neither = intruder.bytes_of(to_wire(samples::bids(2)));
  neither[kBodyKindAt] = 77;
  intruder.write(neither);
  intruder.write(Bytes{0});
  intruder.write(Bytes{0, 1, 0, 0, 1});
  intruder.write(Bytes(5000, 0xff));
  const auto reasons = refusals(*victim, 6);
  ASSERT_EQ(reasons.size(), 6u);
  EXPECT_EQ(reasons[0], "bundle.bid = nan is not allowed");
  EXPECT_EQ(reasons[1], "payload cannot be decoded");
  EXPECT_EQ(reasons[2], "payload cannot be decoded");
  EXPECT_EQ(reasons[3], "payload cannot be decoded");
  EXPECT_EQ(reasons[4], "schema_version = 9 is not allowed");
  EXPECT_EQ(reasons[5], "statement.body = 77 is not allowed");
  EXPECT_EQ(victim->counters().dropped, before + 6);
  EXPECT_EQ(victim->counters().received, 0u);

  intruder.write(to_wire(samples::bids(2)));
  const auto good = next<BidMessage>(*victim);
  ASSERT_TRUE(good);
  EXPECT_TRUE(same(*good, samples::bids(2)));
}

TEST_F(BusTest, GarbageEnumerationInAMissionIsRefused) {
  const auto victim = agent(1);
  Intruder<Mission> intruder(network_, lease_.domain());
  ASSERT_TRUE(eventually([&] { return intruder.matched(); }));
  wire::Mission sample = to_wire(samples::mission());
  sample.auction().policy(static_cast<wire::PolicyKind>(99));
  intruder.write(sample);
  const auto reasons = refusals(*victim, 1);
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0], "auction.policy = 99 is not allowed");
}

TEST_F(BusTest, RandomBytesDoNotBlockWhatComesAfter) {
  const auto victim = agent(1);
  Intruder<BidMessage> intruder(network_, lease_.domain());
  const std::uint64_t before = meet(*victim, intruder);
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    Bytes bytes(random() % 400);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
    // A valid start half of the time, so that the decoder gets past it.
    if (bytes.size() > 8 && i % 2 == 0)
      std::copy_n(Bytes{0, 1, 0, 0, 1, 0, 0, 0}.begin(), 8, bytes.begin());
    wire::Bids key;
    key.sender(static_cast<std::uint32_t>(i));
    intruder.write(bytes, key);
  }
  intruder.write(to_wire(samples::bids(2)));
  const auto good = next<BidMessage>(*victim);
  ASSERT_TRUE(good);
  EXPECT_TRUE(eventually([&] {
    const TrafficCounters now = victim->counters();
    return now.dropped + now.received == before + 501;
  }));
  EXPECT_GT(victim->counters().dropped, 400u);
}

}  // namespace
}  // namespace arcbid
