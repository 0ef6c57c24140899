// SPDX-License-Identifier: GPL-3.0-or-later
// An agent that passes every bid on as a relay, until its standard input ends: bus_peer DOMAIN ID
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "idl/bus.hpp"

int main(int argc, char** argv) {
  using namespace arcbid;
  if (argc != 3) return 2;
  const auto domain = static_cast<std::uint32_t>(std::atoi(argv[1]));
  const AgentId self{static_cast<std::uint32_t>(std::atoi(argv[2]))};
  Bus bus({}, domain, self, 16);
  std::atomic<bool> ended = false;
  std::jthread input([&] {
    while (std::getchar() != EOF) {
    }
    ended = true;
    bus.wake();
  });
  while (!ended)
    for (const Received& received : bus.wait(std::chrono::seconds(1)))
      if (const auto* bids = std::get_if<BidMessage>(&received)) {
        Header header = bids->header;
        header.sender = self;
        bus.publish(RelayMessage{header, bids->statement});
      }
  return 0;
}
