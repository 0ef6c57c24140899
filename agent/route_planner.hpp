// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "core/auction/agent.hpp"
#include "core/route/route.hpp"
#include "core/route/share.hpp"

namespace arcbid {

/// What comes of an agreement.
struct PlannedFlight {
  std::uint64_t view_hash = 0;  ///< 0: of none
  Share share;
  Route route;
};

/// Exchanges and tours may take longer than a lease: they are worked out beside the agent's loop,
/// which goes on saying that the agent lives. One at a time; drops it when it is destroyed.
class RoutePlanner {
 public:
  /// `done` is called from the other thread when a flight is planned.
  explicit RoutePlanner(std::function<void()> done) : done_(std::move(done)) {}
  ~RoutePlanner() { drop(); }
  RoutePlanner(const RoutePlanner&) = delete;
  RoutePlanner& operator=(const RoutePlanner&) = delete;

  bool busy() const { return planning_.valid(); }
  /// Must not be busy. `tasks` must outlive the planning.
  void plan(std::shared_ptr<const Mission> mission, std::shared_ptr<const Transit> transit,
            const TaskSet& tasks, const Agreement& agreement, AgentId self);
  /// What is being planned is not wanted any more: it ends soon, and take() gives a flight of no
  /// agreement.
  void drop() { is_wanted_ = false; }
  /// What was planned, once.
  std::optional<PlannedFlight> take();

 private:
  std::function<void()> done_;
  std::atomic<bool> is_wanted_ = false;
  std::future<PlannedFlight> planning_;
};

}  // namespace arcbid
