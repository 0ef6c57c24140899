// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/replay/run_events.hpp"

namespace arcbid {

/// What a step is about, for filters.
enum class Topic : std::uint8_t { tick, bid, relay, status, decision };
inline constexpr std::array<std::string_view, 5> topic_names{"tick", "bid", "relay", "status",
                                                             "decision"};

/// Which moments are shown. What is not set filters nothing.
struct MomentFilter {
  std::optional<AgentId> agent;
  std::optional<ArcId> arc;  ///< decisions on it, and news about it
  std::optional<Topic> topic;
};

/// A position in a run, and how it moves. Time comes in: there is no clock here. Positions count
/// moments that have passed, from 0 to all.
class Player {
 public:
  Player(const RunArchive& run, const Playback& playback, MomentFilter filter);

  std::size_t position() const { return position_; }
  std::size_t end() const { return end_; }
  TimeNs now_ns() const { return now_ns_; }  ///< since launch
  bool at_end() const { return position_ >= end_; }

  void seek(std::size_t position);
  void seek_time(TimeNs t_ns);
  /// To where somebody first made that decision. False: nobody did.
  bool seek_round(std::uint32_t round);
  /// False: there is no such event.
  bool seek_event(const std::string& name);
  /// To the next event or the one before. False: there is none.
  bool next_event(int direction);
  /// "12.5", "round:3" or "event:agreement". Throws InputError with all that would be legal.
  void seek(const std::string& where);

  /// So many shown moments on, or back; returns those that were passed, in causal order.
  std::vector<std::size_t> step(int shown);
  /// So much real time passes; returns the shown moments that were passed, no more than `most`:
  /// with more the asked rate is not met.
  std::vector<std::size_t> advance(TimeNs real_ns, std::size_t most);

  void set_rate(double rate) { rate_ = rate; }  ///< 0: as fast as possible
  double rate() const { return rate_; }
  /// What became of it since the last seek; none: nothing was played.
  std::optional<double> real_rate() const;
  bool is_behind() const;  ///< the asked rate is not met
  void set_loop(bool loop) { loops_ = loop; }
  bool loops() const { return loops_; }
  void set_begin() { begin_ = position_; }   ///< a loop begins again here
  void set_until(const std::string& where);  ///< and the play ends there

  const std::vector<RunEvent>& events();
  bool is_shown(std::size_t moment) const;

 private:
  std::size_t place(const std::string& where);
  void moved();
  bool concerns(const Moment& moment, const Mark& mark, ArcId arc) const;

  const RunArchive& run_;
  const Playback& playback_;
  MomentFilter filter_;
  std::size_t position_ = 0, begin_ = 0, end_;
  TimeNs now_ns_ = 0;
  double rate_ = 1;
  bool loops_ = false;
  TimeNs played_ns_ = 0, real_ns_ = 0;
  std::optional<std::vector<RunEvent>> events_;  // found when they are first asked for
};

}  // namespace arcbid
