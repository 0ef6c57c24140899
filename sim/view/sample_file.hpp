// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace arcbid {

/// What may become of a sample: covered, or one of eight reasons why not (docs/RUN_DIRECTORY.md).
inline constexpr std::size_t sample_fates = 9;
/// Covered samples by how many stretches of 1 m of the routes see them: 1, 2, 3 to 4, 5 to 8, 9 to
/// 16, 17 to 32, and more.
inline constexpr std::size_t sample_bins = 7;

/// certificate_samples.bin, thinned for a picture of it; what is counted is counted of all samples.
struct ShownSamples {
  std::uint64_t total = 0;
  std::array<std::uint64_t, sample_fates> fates{};
  std::array<std::uint64_t, sample_bins> bins{};
  // Of those that are shown.
  std::vector<float> positions_m;      ///< x, y, z of each
  std::vector<std::int8_t> normals;    ///< x, y, z of each, times 127
  std::vector<std::uint8_t> fate;      ///< an index of `fates`
  std::vector<std::uint16_t> seen_by;  ///< stretches of 1 m of the routes
};

/// At most `limit` samples are shown. What became of few samples, up to a twentieth of the limit,
/// is shown whole, for it would be lost in a picture of millions; the others are thinned evenly.
/// Throws checker::DamagedFile, with the reason and not the file's name.
ShownSamples read_samples(const std::filesystem::path& file, std::uint64_t limit);

}  // namespace arcbid
