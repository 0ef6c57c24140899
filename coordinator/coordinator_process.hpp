// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "coordinator/progress.hpp"
#include "core/io/config.hpp"
#include "core/io/process/process.hpp"
#include "core/io/run/run_log.hpp"
#include "idl/bus.hpp"

namespace arcbid {

struct CoordinatorOptions {
  Config config;
  std::uint32_t domain = 0;
  std::optional<std::filesystem::path> run;  ///< run directory; none: no files are written
  TimeNs epoch_ns = 0;                       ///< launch, on the monotonic clock
  TimeNs not_before_ns = 0;                  ///< no mission is complete before this, since launch
  bool json_events = false;
};

/// Publishes the mission, repeats it to whoever lacks it, and ends it when every living agent has
/// proven agreement and published its route. It takes no part in the auction: agents finish without
/// it.
class CoordinatorProcess {
 public:
  explicit CoordinatorProcess(CoordinatorOptions options);
  Exit run();

 private:
  void handle(const StatusMessage& status);
  std::optional<Exit> ended(TimeNs deadline_ns);
  void handle(const RouteMessage& route);
  void handle(const Malformed& malformed);
  template <class Message>
  void handle(const Message&) {}  // the auction itself is the agents' business

  std::uint64_t mission_id() const;
  void publish_mission();
  void publish_again_if_wanted();
  void warn_if_alone();
  void end_mission(Command command, const std::string& reason);
  void report_traffic();
  TimeNs now_ns() const { return monotonic_ns() - options_.epoch_ns; }

  CoordinatorOptions options_;
  Reporter report_;
  std::optional<RunLog> log_;
  int heard_status_ = 0;  // the kind of record
  Bus bus_;
  Mission mission_;
  std::uint64_t mission_digest_ = 0;
  std::optional<Progress> progress_;
  TimeNs published_ns_ = 0;
  bool warned_alone_ = false;
};

}  // namespace arcbid
