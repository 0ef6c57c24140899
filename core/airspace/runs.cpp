// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/runs.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr double kFarthest_m = 2e6;

/// How far back the cell lies that cell number `n` is compared with; 0: there is none.
class Neighbour {
 public:
  explicit Neighbour(const std::array<std::uint32_t, 3>& cells)
      : row_(cells[0]), layer_(std::size_t{cells[0]} * cells[1]) {}
  std::size_t back(std::size_t n) const {
    if (n % layer_ >= row_) return row_;
    return n >= layer_ ? layer_ : 0;
  }

 private:
  std::size_t row_, layer_;
};

void append_number(std::uint64_t value, std::vector<std::uint8_t>& out) {
  for (; value >= 128; value >>= 7) out.push_back(static_cast<std::uint8_t>(value | 128));
  out.push_back(static_cast<std::uint8_t>(value));
}

/// The run that begins at byte `at`, which is moved behind it; none where the bytes end too early
/// or the number is longer than any run.
std::optional<std::uint64_t> next_run(const std::vector<std::uint8_t>& bytes, std::size_t& at) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 28 && at < bytes.size(); shift += 7) {
    const std::uint8_t byte = bytes[at++];
    value |= std::uint64_t{byte & 127u} << shift;
    if (byte < 128) return value;
  }
  return std::nullopt;
}

bool sane(const Vec3& p) {
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest_m;
}

std::optional<std::string> unsound_runs(const Airspace& airspace, std::uint64_t total) {
  std::uint64_t sum = 0;
  for (std::size_t at = 0; at < airspace.runs.size();) {
    const std::size_t begin = at;
    const auto run = next_run(airspace.runs, at);
    if (!run) return fmt::format("runs: no number at byte {}", begin);
    if (*run == 0 && begin > 0) return fmt::format("runs: an empty run at byte {}", begin);
    sum += *run;
    if (sum > total) return fmt::format("runs: more than the {} cells at byte {}", total, begin);
  }
  if (sum != total) return fmt::format("runs: {} cells instead of {}", sum, total);
  return std::nullopt;
}

std::optional<std::string> unsound_accesses(const Airspace& airspace) {
  for (std::size_t k = 0; k < airspace.accesses.size(); ++k) {
    const Access& access = airspace.accesses[k];
    if (access.points.size() < 2) return fmt::format("accesses[{}]: fewer than two points", k);
    for (const AccessPoint& p : access.points)
      if (!sane(p.position_m)) return fmt::format("accesses[{}]: not a place", k);
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::uint8_t> encode_runs(const Cells& free,
                                      const std::array<std::uint32_t, 3>& cells) {
  const Neighbour neighbour(cells);
  std::vector<std::uint8_t> out;
  std::uint64_t run = 0;
  bool differs = false;
  for (std::size_t n = 0; n < free.size(); ++n) {
    const std::size_t back = neighbour.back(n);
    const bool now = free[n] != (back == 0 ? 1 : free[n - back]);
    if (now != differs) {
      append_number(run, out);
      run = 0;
      differs = now;
    }
    ++run;
  }
  append_number(run, out);
  return out;
}

std::optional<std::string> unsound(const Airspace& airspace) {
  if (airspace.empty()) {
    const bool bare = airspace.runs.empty() && airspace.accesses.empty();
    return bare ? std::nullopt : std::optional<std::string>("cells: none, but there are others");
  }
  std::uint64_t total = 1;
  for (const std::uint32_t cells : airspace.cells) {
    if (cells == 0 || cells > kMostCells) return fmt::format("cells: {} along an axis", cells);
    total *= cells;
    if (total > kMostCells) return fmt::format("cells: more than {}", kMostCells);
  }
  if (!(airspace.cell_m >= 1e-3 && airspace.cell_m <= 1e5))
    return fmt::format("cell_m: {}", airspace.cell_m);
  if (!sane(airspace.low_m)) return "low_m: not a place";
  if (auto reason = unsound_runs(airspace, total)) return reason;
  return unsound_accesses(airspace);
}

Cells decode_runs(const Airspace& airspace) {
  Cells free;
  free.reserve(std::size_t{airspace.cells[0]} * airspace.cells[1] * airspace.cells[2]);
  const Neighbour neighbour(airspace.cells);
  std::uint8_t differs = 0;
  for (std::size_t at = 0; at < airspace.runs.size(); differs ^= 1) {
    const auto run = next_run(airspace.runs, at);
    check(run.has_value(), "the runs of an airspace were looked at before");
    for (std::uint64_t k = 0; k < *run; ++k) {
      const std::size_t back = neighbour.back(free.size());
      free.push_back(differs ^ (back == 0 ? 1 : free[free.size() - back]));
    }
  }
  return free;
}

}  // namespace arcbid
