// SPDX-License-Identifier: GPL-3.0-or-later
#include "idl/guid_prefix.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "core/base/digest.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

// Fast DDS's own vendor id: it speaks to participants of other vendors differently.
constexpr std::array<std::uint8_t, 2> vendor{0x01, 0x0f};
// Fast DDS numbers its participants in the last four bytes: a number with one of these in its
// second byte would be a participant beyond the 16,000th.
constexpr std::uint8_t agent_role = 'A', coordinator_role = 'C';
constexpr std::size_t host_at = 2, life_at = 4, role_at = 9, id_at = 10;

/// The lowest bytes of `value` in [from, to).
void put(GuidPrefix& prefix, std::size_t from, std::size_t to, std::uint64_t value) {
  for (std::size_t i = to; i-- > from; value >>= 8) prefix[i] = static_cast<std::uint8_t>(value);
}

}  // namespace

GuidPrefix new_guid_prefix(std::optional<AgentId> agent, const std::string& host_address) {
  const std::uint32_t id = agent ? agent->value : 0;
  check(id <= 0xffff, "an agent's id has 16 bits");
  static std::atomic<std::uint64_t> made_here = 0;
  utsname name{};
  uname(&name);
  Digest host;
  host.add(std::string_view(name.nodename)).add(std::string_view(host_address));
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  Digest life(host);
  life.add(static_cast<std::uint64_t>(getpid()))
      .add(static_cast<std::uint64_t>(
          std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()))
      .add(++made_here);

  GuidPrefix prefix{};
  std::copy(vendor.begin(), vendor.end(), prefix.begin());
  put(prefix, host_at, life_at, host.value());
  put(prefix, life_at, role_at, life.value());
  prefix[role_at] = agent ? agent_role : coordinator_role;
  put(prefix, id_at, prefix.size(), id);
  return prefix;
}

std::optional<AgentId> agent_of(const GuidPrefix& prefix) {
  const bool ours = std::equal(vendor.begin(), vendor.end(), prefix.begin());
  if (!ours || prefix[role_at] != agent_role) return std::nullopt;
  return AgentId{std::uint32_t{prefix[id_at]} << 8 | prefix[id_at + 1]};
}

}  // namespace arcbid
