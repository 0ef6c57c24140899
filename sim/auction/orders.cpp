// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/orders.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr std::uint64_t most_claims = UINT32_MAX;

std::size_t size_of(std::uint64_t number) {
  std::size_t bytes = 1;
  while (number >>= 7) ++bytes;
  return bytes;
}

void write(std::uint64_t number, Bytes& out) {
  for (; number >= 128; number >>= 7) out.push_back(static_cast<std::uint8_t>(number | 128));
  out.push_back(static_cast<std::uint8_t>(number));
}

/// What is left to read; once it ran out, or a number was too long, all that follows is 0.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t number = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      const std::uint64_t digit = byte();
      number |= (digit & 127) << shift;
      if (digit < 128) return number;
    }
    ok_ = false;
    return 0;
  }
  double bid() {
    std::uint64_t bits = 0;
    for (unsigned shift = 0; shift < 64; shift += 8) bits |= std::uint64_t{byte()} << shift;
    return std::bit_cast<double>(bits);
  }
  bool ok() const { return ok_; }
  bool at_end() const { return ok_ && rest_.empty(); }

 private:
  std::uint8_t byte() {
    if (rest_.empty()) ok_ = false;
    if (!ok_) return 0;
    const std::uint8_t byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
  }
  std::span<const std::uint8_t> rest_;
  bool ok_ = true;
};

/// The claims of these tasks in this order.
const std::vector<Claim>& replayed(const std::vector<Claim>& order, BundleReplay& replay) {
  const auto same =
      std::mismatch(order.begin(), order.end(), replay.claims().begin(), replay.claims().end(),
                    [](const Claim& a, const Claim& b) { return a.task == b.task; });
  replay.keep(static_cast<std::size_t>(same.first - order.begin()));
  for (auto claim = same.first; claim != order.end(); ++claim) replay.take(claim->task);
  return replay.claims();
}

/// The entries, and how many they are.
std::uint64_t write_order(const std::vector<Claim>& before, const std::vector<Claim>& now,
                          Bytes& out) {
  std::uint64_t entries = 0;
  for (auto claim = now.begin(); claim != now.end(); ++entries) {
    const auto is_this = [&](const Claim& other) { return other.task == claim->task; };
    const auto found = std::find_if(before.begin(), before.end(), is_this);
    const auto run = std::mismatch(found, before.end(), claim, now.end(),
                                   [](auto& a, auto& b) { return a.task == b.task; });
    const auto count = static_cast<std::uint64_t>(run.second - claim);
    const auto place = static_cast<std::uint64_t>(found - before.begin());
    const std::uint64_t task = 2ULL * claim->task.value;
    if (count == 0 || (count == 1 && size_of(task) <= size_of(2 * place + 1) + 1)) {
      write(task, out);
      ++claim;
    } else {
      write(2 * place + 1, out);
      write(count, out);
      claim = run.second;
    }
  }
  return entries;
}

/// Tasks that exist, each once.
bool read_order(Reader& in, std::uint64_t entries, const std::vector<Claim>& before,
                std::size_t tasks, std::vector<Claim>& order) {
  std::vector<bool> seen(tasks, false);
  const auto add = [&](std::uint64_t task) {
    if (task >= tasks || seen[task]) return false;
    seen[task] = true;
    order.push_back({TaskId{static_cast<std::uint32_t>(task)}, 0});
    return true;
  };
  for (; entries > 0 && in.ok(); --entries) {
    const std::uint64_t entry = in.number();
    const std::uint64_t place = entry / 2, count = entry % 2 == 1 ? in.number() : 0;
    if (entry % 2 == 0 && !add(entry / 2)) return false;
    if (entry % 2 == 1 && (place > before.size() || count > before.size() - place)) return false;
    for (std::uint64_t n = place; n < place + count; ++n)
      if (!add(before[n].task.value)) return false;
  }
  return in.ok();
}

std::optional<StatementKey> read_key(Reader& in, const StatementKey& before) {
  const std::uint64_t step = in.number();
  const std::uint64_t life = step > 0 ? before.incarnation : in.number();
  const std::uint64_t version = step > 0 ? before.version + step : in.number();
  if (!in.ok() || version > std::numeric_limits<std::uint32_t>::max()) return {};
  return StatementKey{life, false, static_cast<std::uint32_t>(version)};
}

}  // namespace

Bytes encode(const Said& before, const Said& now, BundleReplay& replay) {
  check(!now.key.dead && now.key > before.key && now.bundle.size() < most_claims,
        "what is said is news of the living");
  Bytes out, order;
  if (now.key.incarnation == before.key.incarnation) {
    write(now.key.version - before.key.version, out);
  } else {
    for (const std::uint64_t part : {std::uint64_t{0}, now.key.incarnation}) write(part, out);
    write(now.key.version, out);
  }
  const std::uint64_t entries = write_order(before.bundle, now.bundle, order);
  const bool with_bids = replayed(now.bundle, replay) != now.bundle;
  write(2 * entries + with_bids, out);
  out.insert(out.end(), order.begin(), order.end());
  for (const Claim& claim : now.bundle)
    for (unsigned shift = 0; with_bids && shift < 64; shift += 8)
      out.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint64_t>(claim.bid) >> shift));
  return out;
}

std::optional<Said> decode(std::span<const std::uint8_t> bytes, const Said& before,
                           std::size_t tasks, BundleReplay& replay) {
  Reader in(bytes);
  const auto key = read_key(in, before.key);
  if (!key) return {};
  Said now{*key, {}};
  const std::uint64_t entries = in.number();
  if (!read_order(in, entries / 2, before.bundle, tasks, now.bundle)) return {};
  if (entries % 2 == 0)
    now.bundle = replayed(now.bundle, replay);
  else
    for (Claim& claim : now.bundle) claim.bid = in.bid();
  if (!in.at_end()) return {};
  return now;
}

}  // namespace arcbid
