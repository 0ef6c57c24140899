// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace arcbid::testing {

/// One record of certificate_samples.bin.
struct FiledSample {
  std::array<float, 3> position_m{};
  std::array<std::int8_t, 3> normal{0, 0, 127};
  std::uint8_t fate = 0;
  std::uint16_t seen_by = 1;
};

/// The files as docs/RUN_DIRECTORY.md has them, written here once more.
std::string samples_file(const std::vector<FiledSample>& samples);
nlohmann::json certificate_file(std::size_t samples);
void write_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace arcbid::testing
