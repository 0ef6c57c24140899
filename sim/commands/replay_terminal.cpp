// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/replay_terminal.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "core/io/process/process.hpp"
#include "sim/commands/raw_terminal.hpp"
#include "sim/replay/moment_text.hpp"

namespace arcbid {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t most_at_once = 200;  // lines between two looks at the keyboard
constexpr double least_rate = 1.0 / 1024, most_rate = 1024;

class Screen {
 public:
  Screen(const RunArchive& run, const Playback& playback, Player& player, int step)
      : run_(run), playback_(playback), player_(player), step_(step) {}

  void play() {
    const RawTerminal terminal;
    fmt::print(
        "space pause, right/left (n/p) step, g TIME, r ROUND, e/E next/previous event, + - rate, "
        "l loop, q quit\n");
    status();
    TimeNs last_ns = monotonic_ns();
    while (!quits_ && !stop_requested()) {
      type(terminal.read(idle() ? 200ms : 10ms));
      const TimeNs now_ns = monotonic_ns();
      if (!idle() && !quits_) show(player_.advance(now_ns - last_ns, most_at_once));
      last_ns = now_ns;
      prompt();
    }
    fmt::print("\r\033[K");
    status();
  }

 private:
  bool idle() const { return paused_ || asks_ != 0 || player_.at_end(); }

  void show(const std::vector<std::size_t>& moments) {
    for (const std::size_t moment : moments)
      for (const std::string& line : text_of(run_, playback_, moment))
        fmt::print("\r\033[K{}\n", line);
  }
  void status() { fmt::print("\r\033[K{}\n", status_of(run_, playback_, player_.position())); }

  void prompt() {
    std::string line;
    if (asks_ != 0)
      line = fmt::format("{} {}", asks_ == 'g' ? "to which second?" : "to which round?", answer_);
    else
      line =
          fmt::format("{:.6f} s  {}  rate {}{}", static_cast<double>(player_.now_ns()) * 1e-9,
                      player_.at_end() ? "end"
                      : paused_        ? "paused"
                                       : "plays",
                      player_.rate() == 0 ? "as fast as possible" : fmt::to_string(player_.rate()),
                      player_.loops() ? ", loop" : "");
    const auto real = player_.real_rate();
    if (real && !idle() && (player_.is_behind() || player_.rate() == 0))
      line += fmt::format(" (really {:.2f})", *real);
    fmt::print("\r\033[K{}", line);
    std::fflush(stdout);
  }

  void type(const std::string& typed) {
    for (std::size_t n = 0; n < typed.size(); ++n) {
      if (typed.compare(n, 2, "\033[") == 0 && n + 2 < typed.size()) {
        key(typed[n + 2] == 'C' ? 'n' : typed[n + 2] == 'D' ? 'p' : 0);
        n += 2;
      } else if (asks_ != 0) {
        answer(typed[n]);
      } else {
        key(typed[n]);
      }
    }
  }
  void key(char pressed) {
    switch (pressed) {
      case ' ':
        paused_ = !paused_;
        return;
      case 'n':
        paused_ = true;
        return show(player_.step(step_));
      case 'p':
        paused_ = true;
        player_.step(-step_);
        return status();
      case 'g':
      case 'r':
        asks_ = pressed;
        answer_.clear();
        return;
      case 'e':
      case 'E':
        if (player_.next_event(pressed == 'e' ? 1 : -1)) tell_event();
        return;
      case '+':
      case '-':
        return faster(pressed == '+' ? 2 : 0.5);
      case 'l':
        return player_.set_loop(!player_.loops());
      case 'q':
        quits_ = true;
        return;
      default:
        return;
    }
  }
  void faster(double times) {
    const double rate = player_.rate() == 0 ? 1 : player_.rate() * times;
    player_.set_rate(std::min(std::max(rate, least_rate), most_rate));
  }
  void tell_event() {
    for (const RunEvent& event : player_.events())
      if (event.moments == player_.position()) fmt::print("\r\033[K-- {}\n", event.name);
    status();
  }
  void answer(char typed) {
    if (typed == '\n' || typed == '\r') {
      try {
        player_.seek(asks_ == 'g' ? answer_ : "round:" + answer_);
        status();
      } catch (const InputError& error) {
        fmt::print("\r\033[K{}\n", error.what());
      }
      asks_ = 0;
    } else if (typed == '\033') {
      asks_ = 0;
    } else if (typed == '\177' || typed == '\b') {
      if (!answer_.empty()) answer_.pop_back();
    } else {
      answer_ += typed;
    }
  }

  const RunArchive& run_;
  const Playback& playback_;
  Player& player_;
  const int step_;
  bool paused_ = false, quits_ = false;
  char asks_ = 0;  // 'g' or 'r': a number is being typed
  std::string answer_;
};

}  // namespace

void play_on_terminal(const RunArchive& run, const Playback& playback, Player& player, int step) {
  Screen(run, playback, player, step).play();
}

void play_plainly(const RunArchive& run, const Playback& playback, Player& player, int most) {
  fmt::print("{}\n", status_of(run, playback, player.position()));
  for (int shown = 0; (most == 0 || shown < most) && !stop_requested(); ++shown) {
    const auto passed = player.step(1);
    if (passed.empty()) break;
    for (const std::size_t moment : passed)
      for (const std::string& line : text_of(run, playback, moment)) fmt::print("{}\n", line);
  }
  fmt::print("{}\n", status_of(run, playback, player.position()));
}

}  // namespace arcbid
