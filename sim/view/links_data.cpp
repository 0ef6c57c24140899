// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>
#include <tuple>

#include "sim/view/view_data.hpp"

namespace arcbid {
namespace {

constexpr TimeNs bin_ns = 50'000'000;

using Cell = std::tuple<std::int64_t, std::uint32_t, std::uint32_t>;  // bin, from, to
struct Counts {
  std::uint64_t heard = 0, lost = 0;
};

}  // namespace

/// Each receiver's log says what came and what the fault schedule took away.
nlohmann::json links_data(const RunArchive& run) {
  std::map<Cell, Counts> cells;
  for (const LifeLog& life : run.lives) {
    const std::uint32_t to = life.agent().value;
    for (const Mark& mark : life.marks())
      if (mark.heard) ++cells[{mark.t_ns / bin_ns, mark.heard->sender.value, to}].heard;
    const auto take = [&](const RunLogReader::Record& record) {
      if (record.kind != "lost") return true;
      const auto body = nlohmann::json::parse(record.body, nullptr, false);
      if (body.is_object() && body.value("sender", nlohmann::json()).is_number_unsigned())
        ++cells[{record.t_ns / bin_ns, body["sender"].get<std::uint32_t>(), to}].lost;
      return true;
    };
    if (life.damage())
      life.reader().read_intact(take, [](const RunLogReader::Lost&) {});
    else
      life.reader().read(take, 0, "lost");
  }
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& [cell, counts] : cells) {
    const auto& [bin, from, to] = cell;
    rows.push_back({bin, from, to, counts.heard + counts.lost, counts.lost, 0, 0});
  }
  return {{"bin_s", seconds(bin_ns)}, {"rows", rows}};
}

}  // namespace arcbid
