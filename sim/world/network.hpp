// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "core/auction/agent.hpp"
#include "core/faults/link_model.hpp"
#include "sim/world/spec.hpp"

namespace arcbid {

/// A message on its way to one agent: to all lives that bear its id then.
struct Delivery {
  TimeNs at_ns = 0;
  std::uint64_t order = 0;       ///< breaks ties: first sent, first delivered
  std::size_t from = 0, to = 0;  ///< positions in the fleet
  std::uint32_t from_life = 0;
  bool is_malformed = false;
  std::shared_ptr<Event> event;  ///< shared by all who get it; its time is set on delivery
};

/// The network of a world, in virtual time: every message to every other agent by the link's own
/// fate, plus a latency that no fault explains.
class Network {
 public:
  explicit Network(const WorldSpec& spec);

  /// Hears what the faults of links did to a message when it was sent.
  using Watch = std::function<void(const Delivery& message, const Fate& fate)>;
  void watch(Watch watch) { watch_ = std::move(watch); }

  /// From `from` to everybody else. `sequence` decides its fate on each link.
  template <class Message>
  void broadcast(std::size_t from, std::uint32_t life, const Message& message, TimeNs now_ns,
                 bool is_malformed = false);

  bool empty() const { return queue_.empty(); }
  TimeNs next_ns() const { return queue_.top().at_ns; }
  Delivery pop();

  bool has_link(std::size_t from, std::size_t to) const { return linked_[from * size_ + to]; }
  std::uint64_t messages() const { return messages_; }
  std::uint64_t bytes() const { return bytes_; }  ///< once for every receiver that has a link
  /// When the last message arrives that was sent before `calm_ns`.
  TimeNs last_arrival_ns() const { return last_arrival_ns_; }

 private:
  struct Later {
    bool operator()(const Delivery& a, const Delivery& b) const {
      return a.at_ns != b.at_ns ? a.at_ns > b.at_ns : a.order > b.order;
    }
  };
  void send(const Delivery& message, std::uint64_t sequence, std::uint64_t bytes, TimeNs now_ns);
  void arrive(Delivery message, TimeNs at_ns, std::uint64_t sequence, TimeNs now_ns);

  std::size_t size_;
  std::uint64_t seed_;
  Range<TimeNs> latency_ns_;
  TimeNs faults_end_ns_, calm_ns_;
  std::vector<LinkModel> links_;  // by from, then to; none without link faults
  std::vector<bool> linked_, has_twin_;
  std::priority_queue<Delivery, std::vector<Delivery>, Later> queue_;
  std::uint64_t order_ = 0, messages_ = 0, bytes_ = 0;
  TimeNs last_arrival_ns_ = 0;
  Watch watch_;  // empty: nobody
};

}  // namespace arcbid
