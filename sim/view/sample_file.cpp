// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/sample_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

#include "sim/checker/json_field.hpp"

namespace arcbid {
namespace {

using checker::DamagedFile;

constexpr std::string_view magic = "ARCBSMPL";
constexpr std::uint32_t version = 1;
constexpr std::size_t head_bytes = 16, sample_bytes = 20;

template <class T>
T value_at(const char* bytes) {
  static_assert(std::endian::native == std::endian::little);
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

std::string whole(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw DamagedFile("the file is missing");
  if (!std::filesystem::is_regular_file(file, ignored)) throw DamagedFile("not a regular file");
  std::ifstream in(file, std::ios::binary);
  std::string bytes(std::filesystem::file_size(file, ignored), '\0');
  if (!in || !in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw DamagedFile("the file cannot be read");
  return bytes;
}

/// The number of samples.
std::size_t check_head(const std::string& bytes) {
  if (bytes.size() < head_bytes || !bytes.starts_with(magic))
    throw DamagedFile(fmt::format("does not begin with {} and two numbers", magic));
  if (const auto is = value_at<std::uint32_t>(&bytes[8]); is != version)
    throw DamagedFile(fmt::format("version is {}, must be {}", is, version));
  const std::size_t count = value_at<std::uint32_t>(&bytes[12]);
  if (const std::size_t must = head_bytes + count * sample_bytes; bytes.size() != must)
    throw DamagedFile(
        fmt::format("{} bytes, must be {} for its {} samples", bytes.size(), must, count));
  return count;
}

struct Record {
  std::array<float, 3> position_m;
  std::array<std::int8_t, 3> normal;
  std::uint8_t fate;
  std::uint16_t seen_by;
};

Record record_at(const std::string& bytes, std::size_t index) {
  const char* at = &bytes[head_bytes + index * sample_bytes];
  const Record record{value_at<std::array<float, 3>>(at),
                      value_at<std::array<std::int8_t, 3>>(at + 12),
                      value_at<std::uint8_t>(at + 15), value_at<std::uint16_t>(at + 16)};
  for (const float v : record.position_m)
    if (!std::isfinite(v))
      throw DamagedFile(fmt::format("sample {}: position is {}, must be finite", index, v));
  if (record.fate >= sample_fates)
    throw DamagedFile(fmt::format("sample {}: class is {}, must be 0 to {}", index, record.fate,
                                  sample_fates - 1));
  return record;
}

std::size_t bin_of(std::uint16_t seen_by) {
  const auto bin =
      static_cast<std::size_t>(std::bit_width(std::max(seen_by, std::uint16_t{1}) - 1u));
  return std::min(bin, sample_bins - 1);
}

/// Says of one sample after the other whether it is shown: of those to be thinned one of each of
/// equally long stretches, not always at the same place, for the two sides of a point may
/// alternate.
class Thinning {
 public:
  Thinning(const ShownSamples& counted, std::uint64_t limit) : slots_(limit) {
    for (std::size_t f = 0; f < sample_fates; ++f) {
      whole_[f] = counted.total <= limit || counted.fates[f] <= limit / 20;
      if (whole_[f])
        slots_ -= counted.fates[f];
      else
        rest_ += counted.fates[f];
    }
  }
  bool shows(std::uint8_t fate) {
    if (whole_[fate]) return true;
    const std::uint64_t at = passed_++;
    while (at >= begin(stretch_ + 1)) ++stretch_;
    const double golden = 0.6180339887498949 * static_cast<double>(stretch_);
    const auto length = static_cast<double>(begin(stretch_ + 1) - begin(stretch_));
    const double within = (golden - std::floor(golden)) * length;
    return at == begin(stretch_) + static_cast<std::uint64_t>(within);
  }

 private:
  std::uint64_t begin(std::uint64_t stretch) const { return stretch * rest_ / slots_; }

  std::array<bool, sample_fates> whole_{};
  std::uint64_t slots_, rest_ = 0, passed_ = 0, stretch_ = 0;
};

}  // namespace

ShownSamples read_samples(const std::filesystem::path& file, std::uint64_t limit) {
  const std::string bytes = whole(file);
  ShownSamples out;
  out.total = check_head(bytes);
  for (std::size_t i = 0; i < out.total; ++i) {
    const Record record = record_at(bytes, i);
    ++out.fates[record.fate];
    if (record.fate == 0) ++out.bins[bin_of(record.seen_by)];
  }
  Thinning thinning(out, limit);
  for (std::size_t i = 0; i < out.total; ++i) {
    const Record record = record_at(bytes, i);
    if (!thinning.shows(record.fate)) continue;
    out.positions_m.insert(out.positions_m.end(), record.position_m.begin(),
                           record.position_m.end());
    out.normals.insert(out.normals.end(), record.normal.begin(), record.normal.end());
    out.fate.push_back(record.fate);
    out.seen_by.push_back(record.seen_by);
  }
  return out;
}

}  // namespace arcbid
