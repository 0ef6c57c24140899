// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/launcher/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace arcbid {

Console::Console() : terminal_(isatty(STDOUT_FILENO) != 0) {}

void Console::wipe() {
  if (dirty_) fmt::print("\r\033[K");
  dirty_ = false;
}

void Console::line(double time_s, const std::string& text) {
  wipe();
  fmt::print("{:7.2f} s  {}\n", time_s, text);
  std::fflush(stdout);
}

void Console::progress(double time_s, const Monitor& monitor) {
  std::size_t up = 0, started = 0, agreed = 0, routed = 0;
  std::uint32_t round = 0;
  for (const auto& [id, agent] : monitor.agents()) {
    up += agent.up;
    started += agent.started;
    agreed += !agent.agreed_hash.empty();
    routed += !agent.routed_hash.empty() && agent.routed_hash == agent.agreed_hash;
    round = std::max(round, agent.round);
  }
  const std::size_t all = monitor.agents().size();
  for (; warnings_ < monitor.warnings().size(); ++warnings_)
    line(time_s, "warning: " + monitor.warnings()[warnings_]);
  if (!published_ && monitor.arcs()) {
    published_ = true;
    line(time_s, fmt::format("mission published: {} arcs, {:.0f} m", *monitor.arcs(),
                             monitor.metres()));
  }
  const auto milestone = [&](std::size_t& before, std::size_t now, const std::string& text) {
    if (now == all && before != all) line(time_s, text);
    before = now;
  };
  milestone(up_, up, fmt::format("{} agents up", all));
  milestone(started_, started,
            fmt::format("everybody is here: bidding for {} tasks", monitor.tasks()));
  milestone(agreed_, agreed, fmt::format("agreement proven by all, round {}", round));
  milestone(routed_, routed, "all routes published");
  if (!terminal_ || routed == all) return;
  fmt::print("\r\033[K{:7.2f} s  agents {}/{}  bidding {}  round {}  agreed {}  routed {}", time_s, up,
             all, started, round, agreed, routed);
  std::fflush(stdout);
  dirty_ = true;
}

}  // namespace arcbid
