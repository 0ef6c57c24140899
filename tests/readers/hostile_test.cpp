// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files must be read or refused in one line: no crash, no hang, no allocation that a count
// inside the file asks for. Run under the sanitizers too.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "core/base/error.hpp"
#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

constexpr int kRounds = 200;

std::vector<std::pair<std::string, std::string>> sample_files() {
  const auto box = samples::box();
  return {{"a.pcd", samples::pcd(box, "ascii")},
          {"b.pcd", samples::pcd(box, "binary")},
          {"c.pcd", samples::pcd(box, "binary_compressed")},
          {"a.ply", samples::ply("ascii")},
          {"b.ply", samples::ply("binary_little_endian")},
          {"c.ply", samples::ply("binary_big_endian")},
          {"a.obj", samples::obj() + "f 1 2 4 3\nf 1 2 8 7 5\n"},
          {"a.stl", samples::stl(true)},
          {"b.stl", samples::stl(false)},
          {"a.las", samples::las(box)},
          {"b.las", samples::las(box, {4, 6, 0.01, Vec3::Zero()})},
          {"a.xyz", "8\n" + samples::xyz(box)}};
}

class Damage {
 public:
  explicit Damage(std::uint32_t seed) : random_(seed) {}

  /// A few changes at random places: a byte, a huge number, a digit, a cut, a doubled stretch.
  std::string apply(std::string bytes) {
    for (std::size_t change = 0; change <= below(4) && !bytes.empty(); ++change) {
      const std::size_t at = below(bytes.size());
      switch (below(6)) {
        case 0:
          bytes[at] = static_cast<char>(below(256));
          break;
        case 1:
          bytes[at] = "0123456789-.e/ \n"[below(16)];
          break;
        case 2:
          bytes.replace(at, 4, "\xff\xff\xff\x7f");
          break;
        case 3:
          bytes.resize(at);
          break;
        case 4:
          bytes.insert(at, bytes.substr(at, below(64)));
          break;
        case 5:
          bytes.insert(at, "99999999");
          break;
      }
    }
    return bytes;
  }

 private:
  std::size_t below(std::size_t end) {
    return boost::random::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }
  boost::random::mt19937 random_;
};

/// Reads or refuses; the number of files read.
int try_read(const std::string& name, const std::string& bytes) {
  try {
    samples::read(name, bytes);
    return 1;
  } catch (const InputError& e) {
    EXPECT_EQ(std::string_view(e.what()).find('\n'), std::string_view::npos) << e.what();
    return 0;
  }
}

long peak_memory_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(Hostile, MutatedFilesAreReadOrRefused) {
  const long before = peak_memory_kib();
  int read = 0, tried = 0;
  for (const auto& [name, bytes] : sample_files()) {
    ASSERT_EQ(try_read(name, bytes), 1) << name;
    for (int round = 0; round < kRounds; ++round) {
      SCOPED_TRACE(fmt::format("{} seed {}", name, round));
      read += try_read(name, Damage(static_cast<std::uint32_t>(round)).apply(bytes));
      ++tried;
    }
  }
  EXPECT_GT(read, tried / 20);      // the damage is fine enough to reach the payload
  EXPECT_LT(read, tried * 9 / 10);  // and coarse enough to be seen
  EXPECT_LT(peak_memory_kib() - before, 200'000);
}

TEST(Hostile, EveryTruncationIsReadOrRefused) {
  for (const auto& [name, bytes] : sample_files()) {
    for (std::size_t size = 0; size < bytes.size(); size += 7) {
      SCOPED_TRACE(fmt::format("{} cut to {} bytes", name, size));
      try_read(name, bytes.substr(0, size));
    }
  }
}

TEST(Hostile, HugeCountsAreRefusedWithoutAllocating) {
  const long before = peak_memory_kib();
  const std::string pcd_head =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4000000000\n"
      "HEIGHT 1\nPOINTS 4000000000\nDATA ";
  for (const std::string data :
       {"ascii\n1 2 3\n", "binary\nabcdefghijklmn", "binary_compressed\nabcdefghijklmn"}) {
    EXPECT_EQ(try_read("a.pcd", pcd_head + data), 0);
  }
  const std::string ply_head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
      "property float y\nproperty float z\nelement face 4000000000\n"
      "property list uint int vertex_indices\nelement nothing 4000000000\nend_header\n";
  EXPECT_EQ(try_read("a.ply", ply_head + "abcdefghijkl"), 0);
  std::string list = ply_head;
  list.replace(list.find("4000000000"), 10, "1");
  EXPECT_EQ(try_read("a.ply", list + std::string(12, 'a') + "\xff\xff\xff\xff" + "abcd"), 0);
  std::string las = samples::las(samples::box());
  samples::put(las, 107, std::uint32_t{0xffffffff});
  EXPECT_EQ(try_read("a.las", las), 0);
  std::string stl = samples::stl(false);
  samples::put(stl, 80, std::uint32_t{0xffffffff});
  EXPECT_EQ(try_read("a.stl", stl), 0);
  EXPECT_LT(peak_memory_kib() - before, 100'000);
}

}  // namespace
}  // namespace arcbid
