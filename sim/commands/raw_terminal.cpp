// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/raw_terminal.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

// Signal handlers must find them.
termios as_found, raw;
constexpr std::array fatal{SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};

extern "C" void restore_and_end(int signal) {
  tcsetattr(STDIN_FILENO, TCSANOW, &as_found);
  std::signal(signal, SIG_DFL);
  raise(signal);
}
extern "C" void restore_and_stop(int) {
  tcsetattr(STDIN_FILENO, TCSANOW, &as_found);
  raise(SIGSTOP);  // and from here on when it is continued
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

}  // namespace

RawTerminal::RawTerminal() {
  if (tcgetattr(STDIN_FILENO, &as_found) != 0)
    throw InputError("standard input: is not a terminal; without one, send the output to a file");
  raw = as_found;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  raw.c_cc[VMIN] = 1;
  raw.c_cc[VTIME] = 0;
  for (const int signal : fatal) std::signal(signal, restore_and_end);
  std::signal(SIGTSTP, restore_and_stop);
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
}

RawTerminal::~RawTerminal() {
  tcsetattr(STDIN_FILENO, TCSANOW, &as_found);
  for (const int signal : fatal) std::signal(signal, SIG_DFL);
  std::signal(SIGTSTP, SIG_DFL);
}

std::string RawTerminal::read(std::chrono::milliseconds timeout) const {
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(timeout.count())) <= 0) return "";
  std::array<char, 64> bytes{};
  const ssize_t got = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (got <= 0) return "q";  // the terminal is gone
  return {bytes.data(), static_cast<std::size_t>(got)};
}

}  // namespace arcbid
