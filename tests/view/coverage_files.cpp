// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/view/coverage_files.hpp"

#include <cstring>
#include <fstream>

namespace arcbid::testing {
namespace {

using nlohmann::json;

void append_number(std::string& out, std::uint32_t value, int bytes) {
  for (int b = 0; b < bytes; ++b) out.push_back(static_cast<char>(value >> (8 * b)));
}

}  // namespace

std::string samples_file(const std::vector<FiledSample>& samples) {
  std::string out = "ARCBSMPL";
  append_number(out, 1, 4);
  append_number(out, static_cast<std::uint32_t>(samples.size()), 4);
  for (const FiledSample& sample : samples) {
    for (const float axis : sample.position_m) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &axis, 4);
      append_number(out, bits, 4);
    }
    for (const std::int8_t axis : sample.normal)
      append_number(out, static_cast<std::uint8_t>(axis), 1);
    append_number(out, sample.fate, 1);
    append_number(out, sample.seen_by, 2);
    append_number(out, sample.fate < 3 ? 1 : 0, 1);
    append_number(out, 0, 1);
  }
  return out;
}

json certificate_file(std::size_t samples) {
  const json near{{"distance_m", 1.75}, {"leg", 3}, {"at_m", {10.5, -4.0, 12.25}}};
  return {
      {"schema", 1},
      {"surface_samples", samples},
      {"visible_samples", 6},
      {"covered_samples", 4},
      {"covered_visible_samples", 4},
      {"ground_samples", 2},
      {"coverage_of_visible", 0.75},
      {"coverage_of_total", 0.5},
      {"uncovered", {{{"reason", "missed"}, {"count", 2}}, {{"reason", "occluded"}, {"count", 3}}}},
      {"flown_m", 120.5},
      {"metres_per_m2", 0.4},
      {"safety_m", 2.0},
      {"tolerance_m", 0.001},
      {"below_floor_m", 0.0},
      {"spacing_m", 0.3},
      {"min_clearance_m", 1.75},
      {"clearance", {{{"agent", 1}, {"nearest", near}}, {{"agent", 4}, {"nearest", nullptr}}}}};
}

void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace arcbid::testing
