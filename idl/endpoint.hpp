// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <exception>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <mutex>
#include <string>
#include <utility>

#include "idl/convert.hpp"
#include "idl/inbox.hpp"
#include "idl/peer_table.hpp"
#include "idl/topics.hpp"

namespace arcbid {

/// A generated type that survives any payload. Fast DDS decodes on its own threads, also outside of
/// listeners (to find a sample's key), where an exception would end the process; and a sample that
/// throws stays in the reader's history and blocks those behind it. What can't be decoded therefore
/// becomes a blank sample, whose schema version (kUndecodable) is refused like any other foreign
/// one.
template <class Generated>
class GuardedType : public Generated {
 public:
  using Sample = typename Generated::type;

  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    try {
      if (Generated::deserialize(payload, data)) return true;
    } catch (const std::exception&) {
      // Fast CDR's own exceptions, or no memory for a length that the payload lied about.
    }
    *static_cast<Sample*>(data) = Sample();
    return true;
  }

  /// The generated one works in a buffer of the type object, which writers and readers share.
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool md5) override {
    const std::scoped_lock lock(mutex_);
    return Generated::getKey(data, handle, md5);
  }

 private:
  std::mutex mutex_;
};

struct AtomicCounters {
  std::atomic<std::uint64_t> sent = 0, received = 0, dropped = 0, bytes_sent = 0;
};

/// Where a bus's listeners leave what they hear.
struct Reception {
  Inbox inbox;
  PeerTable peers;
  AtomicCounters counters;
};

/// Takes one topic's samples, checks them, and leaves them in the inbox.
template <class Message>
class Listener : public eprosima::fastdds::dds::DataReaderListener,
                 public eprosima::fastdds::dds::DataWriterListener {
 public:
  using Sample = typename Topic<Message>::Type::type;

  Listener(Reception& reception, bool counts_writers, bool counts_readers)
      : reception_(reception), counts_writers_(counts_writers), counts_readers_(counts_readers) {}

  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override {
    try {
      while (take_one(*reader)) {
      }
    } catch (const std::exception& error) {  // this is a DDS thread: nothing may get out
      refuse(error.what());
    }
  }

  void on_subscription_matched(
      eprosima::fastdds::dds::DataReader*,
      const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override {
    if (counts_writers_)
      reception_.peers.writer_matched(prefix_of(status.last_publication_handle),
                                      status.current_count_change);
  }

  void on_publication_matched(
      eprosima::fastdds::dds::DataWriter*,
      const eprosima::fastdds::dds::PublicationMatchedStatus& status) override {
    if (counts_readers_)
      reception_.peers.reader_matched(prefix_of(status.last_subscription_handle),
                                      status.current_count_change);
  }

 private:
  static PeerTable::Prefix prefix_of(const eprosima::fastrtps::rtps::InstanceHandle_t& endpoint) {
    return eprosima::fastrtps::rtps::iHandle2GUID(endpoint).guidPrefix;
  }

  bool take_one(eprosima::fastdds::dds::DataReader& reader) {
    Sample sample;
    eprosima::fastdds::dds::SampleInfo info;
    if (reader.take_next_sample(&sample, &info) !=
        eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK)
      return false;
    const bool own = prefix_of(info.publication_handle) == reader.guid().guidPrefix;
    if (info.valid_data && !own) deliver(sample);
    return true;
  }

  void deliver(const Sample& sample) {
    Decoded<Message> decoded = from_wire(sample);
    if (const auto* reason = std::get_if<std::string>(&decoded)) return refuse(*reason);
    ++reception_.counters.received;
    constexpr bool expendable = Topic<Message>::delivery != Delivery::latched;
    if (!reception_.inbox.put(std::get<Message>(std::move(decoded)), expendable))
      ++reception_.counters.dropped;
  }

  void refuse(const std::string& reason) {
    ++reception_.counters.dropped;
    reception_.inbox.put(Malformed{Topic<Message>::name, reason}, true);
  }

  Reception& reception_;
  const bool counts_writers_, counts_readers_;
};

}  // namespace arcbid
