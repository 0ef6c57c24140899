// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/wal.hpp"

#include <fstream>
#include <string>

namespace arcbid {
namespace {

constexpr std::size_t header_size = 32, frame_head_size = 24;

/// SQLite's file format, section 4: numbers are big-endian, the checksum runs over pairs of words
/// in the order of bytes that the header names.
class Wal {
 public:
  explicit Wal(std::string bytes) : bytes_(std::move(bytes)) {}

  WalState state() {
    WalState out;
    if (bytes_.size() < header_size) return out;
    swapped_ = (word(0) & 1) == 0;
    page_ = word(8);
    if (page_ < 512 || page_ > 65536) page_ = 4096;  // what all logs have
    const bool head_counts = (word(0) | 1) == 0x377f0683 && sums(0, 24) && sum_is_at(24);
    bool counts = head_counts;
    std::size_t since_commit = 0, at = header_size;
    const std::size_t salt = head_counts ? 16 : at + 8;
    for (; at + frame_head_size + page_ <= bytes_.size(); at += frame_head_size + page_) {
      const bool is_of_an_earlier_round =
          word(at + 8) != word(salt) || word(at + 12) != word(salt + 4);
      if (is_of_an_earlier_round) break;
      counts = counts && sums(at, 8) && sums(at + frame_head_size, page_) && sum_is_at(at + 16);
      const bool commits = word(at + 4) != 0;
      ++since_commit;
      if (!commits) continue;
      if (counts)
        ++out.commits, out.frames += since_commit;
      else
        ++out.lost_commits;
      since_commit = 0;
    }
    const bool is_cut = at < bytes_.size() && at + frame_head_size + page_ > bytes_.size();
    out.unfinished_bytes =
        since_commit * (frame_head_size + page_) + (is_cut ? bytes_.size() - at : 0);
    return out;
  }

 private:
  std::uint32_t word(std::size_t at, bool swapped = false) const {
    std::uint32_t value = 0;
    for (std::size_t n = 0; n < 4; ++n)
      value = value << 8 | static_cast<unsigned char>(bytes_[at + (swapped ? 3 - n : n)]);
    return value;
  }
  bool sums(std::size_t from, std::size_t size) {
    for (std::size_t at = from; at < from + size; at += 8) {
      sum_[0] += word(at, swapped_) + sum_[1];
      sum_[1] += word(at + 4, swapped_) + sum_[0];
    }
    return true;
  }
  bool sum_is_at(std::size_t at) const { return word(at) == sum_[0] && word(at + 4) == sum_[1]; }

  std::string bytes_;
  bool swapped_ = false;
  std::size_t page_ = 0;
  std::uint32_t sum_[2] = {0, 0};
};

}  // namespace

WalState wal_state(const std::filesystem::path& file) {
  std::ifstream in(file.string() + "-wal", std::ios::binary);
  return Wal(std::string(std::istreambuf_iterator<char>(in), {})).state();
}

}  // namespace arcbid
