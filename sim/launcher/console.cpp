// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace arcbid {

Console::Console(FaultTier tier) : terminal_(isatty(STDOUT_FILENO) != 0), tier_(tier) {}

void Console::wipe() {
  if (dirty_) fmt::print("\r\033[K");
  dirty_ = false;
}

void Console::line(double time_s, const std::string& text) {
  wipe();
  fmt::print("{:7.2f} s  {}\n", time_s, text);
  std::fflush(stdout);
}

namespace {

/// What a fault schedule has done to links so far, when there is one.
std::string losses(const Monitor& monitor, FaultTier tier) {
  LinkTraffic sum;
  for (const auto& [link, traffic] : monitor.links()) sum += traffic;
  if (sum.sent == 0) return "";
  return fmt::format("  links: {} {} sent, {} dropped, {} delayed, {} duplicated", sum.sent,
                     name_of(tier), sum.dropped, sum.delayed, sum.duplicated);
}

}  // namespace

void Console::progress(double time_s, const Monitor& monitor) {
  std::size_t all = 0, up = 0, started = 0, agreed = 0, routed = 0;
  std::uint32_t round = 0;
  for (const auto& [id, agent] : monitor.agents()) {
    if (agent.gone) continue;
    ++all;
    up += agent.up;
    started += agent.started;
    agreed += !agent.agreed_hash.empty();
    routed += !agent.routed_hash.empty() && agent.routed_hash == agent.agreed_hash;
    round = std::max(round, agent.round);
  }
  for (; warnings_ < monitor.warnings().size(); ++warnings_)
    line(time_s, "warning: " + monitor.warnings()[warnings_]);
  if (monitor.refused() > 0 && !std::exchange(refusal_told_, true))
    line(time_s, "warning: a message was refused: " + monitor.first_refusal());
  if (monitor.arcs() && !std::exchange(published_, true))
    line(time_s,
         fmt::format("mission published: {} arcs, {:.0f} m", *monitor.arcs(), monitor.metres()));
  // Said again when an agreement was reopened and reached anew.
  const auto milestone = [&](bool& told, std::size_t count, const std::string& text) {
    const bool now = all > 0 && count == all;
    if (now && !told) line(time_s, text);
    told = now;
  };
  milestone(up_, up, fmt::format("{} agents up", all));
  milestone(started_, started,
            fmt::format("everybody is here: bidding for {} tasks", monitor.tasks()));
  milestone(agreed_, agreed, fmt::format("agreement proven by all {}, round {}", all, round));
  milestone(routed_, routed, fmt::format("all {} routes published", all));
  if (!terminal_ || routed_) return;
  fmt::print("\r\033[K{:7.2f} s  agents {}/{}  bidding {}  round {}  agreed {}  routed {}{}",
             time_s, up, all, started, round, agreed, routed, losses(monitor, tier_));
  std::fflush(stdout);
  dirty_ = true;
}

}  // namespace arcbid
