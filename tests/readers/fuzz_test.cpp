// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzzer that knows what structure files are made of: words, lines, counts, and each other. What
// is read must be sound, what is refused must be so in one line, and neither may take much memory.
// More: ARCBID_FUZZ_ROUNDS=20000 ARCBID_FUZZ_SEED=7 build/tests/readers_test
// --gtest_filter='FuzzedReaders.*', best in the asan build.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cstdlib>

#include "core/base/error.hpp"
#include "tests/readers/samples.hpp"

namespace arcbid {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

constexpr long kMostKib = 200'000;
constexpr const char* kNames[] = {"a.pcd", "a.ply", "a.obj", "a.stl",
                                  "a.las", "a.xyz", "a",     "a.laz"};
constexpr std::string_view kWords[] = {"nan",
                                       "inf",
                                       "-inf",
                                       "1e999",
                                       "1e-400",
                                       "1e300",
                                       "-1",
                                       "0",
                                       "-0",
                                       "2147483648",
                                       "4294967295",
                                       "18446744073709551616",
                                       "99999999",
                                       "0x10",
                                       "1,5",
                                       "ply",
                                       "solid",
                                       "endsolid",
                                       "end_header",
                                       "element vertex 3",
                                       "element face 1",
                                       "property list uchar int vertex_indices",
                                       "property list float double x",
                                       "property double x",
                                       "format ascii 1.0",
                                       "DATA ascii",
                                       "DATA binary",
                                       "DATA binary_compressed",
                                       "POINTS 4000000000",
                                       "WIDTH 0",
                                       "FIELDS x y z",
                                       "COUNT",
                                       "SIZE 8 8 8",
                                       "TYPE F F F",
                                       "facet normal",
                                       "endloop",
                                       "vertex",
                                       "v",
                                       "f",
                                       "f -1 -2 -3",
                                       "f 1 1 1",
                                       "f 1/2/3 2//4 3",
                                       "#",
                                       "\\",
                                       "\"",
                                       "\t",
                                       "\r\n",
                                       "\n\n",
                                       "\xef\xbb\xbf"};
constexpr std::uint64_t kNumbers[] = {0,
                                      1,
                                      2,
                                      0x7f,
                                      0x80,
                                      0xff,
                                      0x7fff,
                                      0xffff,
                                      0x7fffffff,
                                      0x80000000,
                                      0xffffffff,
                                      0x7ff0000000000000,
                                      0x7fffffffffffffff,
                                      0xffffffffffffffff};

Files sound_files() {
  const auto box = samples::box();
  Files files{{"a.pcd", samples::pcd(box, "ascii")},
              {"a.pcd", samples::pcd(box, "binary")},
              {"a.pcd", samples::pcd(box, "binary_compressed")},
              {"a.ply", samples::ply("ascii")},
              {"a.ply", samples::ply("binary_little_endian")},
              {"a.ply", samples::ply("binary_big_endian")},
              {"a.ply", samples::ply("ascii", false)},
              {"a.obj", samples::obj() + "vn 0 0 1\nf 1//1 2//1 4//1 3//1\nf -1 -2 -4\n"},
              {"a.stl", samples::stl(true)},
              {"a.stl", samples::stl(false)},
              {"a.xyz", "8\n" + samples::xyz(box)},
              {"a.xyz", "# x y z\n" + samples::xyz(box)}};
  for (const auto& [minor, format] : {std::pair{0, 0}, {2, 1}, {2, 2}, {2, 3}, {4, 6}, {4, 7}})
    files.emplace_back("a.las", samples::las(box, {minor, format, 0.01, Vec3::Zero()}));
  return files;
}

class Fuzzer {
 public:
  Fuzzer(const Files& files, std::uint32_t seed) : files_(files), random_(seed) {}

  std::size_t below(std::size_t end) {
    return boost::random::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  std::string mutated(std::string bytes) {
    for (std::size_t n = below(3) + 1; n > 0 && !bytes.empty(); --n) mutate(bytes);
    return bytes;
  }

 private:
  void mutate(std::string& bytes) {
    const std::size_t at = below(bytes.size());
    switch (below(8)) {
      case 0:
        return replace_word(bytes, at);
      case 1:
        bytes.insert(at, fmt::format(" {}\n", kWords[below(std::size(kWords))]));
        return;
      case 2:
        return overwrite(bytes, at);
      case 3:
        bytes.resize(at);
        return;
      case 4:
        return take_line(bytes, at, below(2) == 0);
      case 5:
        return splice(bytes, at);
      case 6:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        return;
      default:
        bytes.insert(at, std::string(1 + below(3000), " 0\n\x00"[below(4)]));
    }
  }

  void replace_word(std::string& bytes, std::size_t at) {
    const std::size_t before = bytes.find_last_of(" \n", at);
    const std::size_t from = before == std::string::npos ? 0 : std::min(before + 1, bytes.size());
    const std::size_t to = std::min(bytes.find_first_of(" \n", from), bytes.size());
    bytes.replace(from, to - from, kWords[below(std::size(kWords))]);
  }

  void overwrite(std::string& bytes, std::size_t at) {
    const std::uint64_t number = kNumbers[below(std::size(kNumbers))];
    const std::size_t width = std::size_t{1} << below(4);
    for (std::size_t k = 0; k < width && at + k < bytes.size(); ++k)
      bytes[at + k] = static_cast<char>(number >> 8 * k);
  }

  /// Leaves a line out, or puts it somewhere else too.
  void take_line(std::string& bytes, std::size_t at, bool out) {
    const std::size_t before = bytes.rfind('\n', at);
    const std::size_t from = before == std::string::npos ? 0 : before;
    const std::string line = bytes.substr(from, bytes.find('\n', from + 1) - from);
    if (out)
      bytes.erase(from, line.size());
    else
      bytes.insert(below(bytes.size()), line);
  }

  /// The head of this one, the tail of another.
  void splice(std::string& bytes, std::size_t at) {
    const std::string& other = files_[below(files_.size())].second;
    bytes.replace(at, std::string::npos, other, below(other.size()));
  }

  const Files& files_;
  boost::random::mt19937 random_;
};

long peak_memory_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

void expect_sound(const Structure& s) {
  for (const Vec3& p : s.points) ASSERT_TRUE(p.allFinite());
  for (const auto& triangle : s.triangles)
    for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, s.points.size());
}

/// Whether it was read.
bool survives(const std::string& name, const std::string& bytes) {
  try {
    const StructureInput input = samples::read(name, bytes);
    expect_sound(input.structure);
    for (const std::string& line : input.warnings) EXPECT_EQ(line.find('\n'), std::string::npos);
    return true;
  } catch (const InputError& e) {
    const std::string line = e.what();
    EXPECT_FALSE(line.empty());
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    EXPECT_LT(line.size(), 1000u) << line;
    return false;
  }
}

std::uint32_t asked(const char* variable, std::uint32_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

TEST(FuzzedReaders, ReadSoundStructuresOrRefuseInOneLine) {
  const Files files = sound_files();
  const std::uint32_t rounds = asked("ARCBID_FUZZ_ROUNDS", 150);
  const std::uint32_t seed = asked("ARCBID_FUZZ_SEED", 1);
  const long before = peak_memory_kib();
  std::uint64_t read = 0, tried = 0;
  for (std::size_t f = 0; f < files.size(); ++f) {
    ASSERT_TRUE(survives(files[f].first, files[f].second)) << files[f].first;
    for (std::uint32_t round = 0; round < rounds; ++round) {
      SCOPED_TRACE(fmt::format("file {} ({}), seed {}, round {}", f, files[f].first, seed, round));
      Fuzzer fuzzer(files, seed * 1'000'003 + static_cast<std::uint32_t>(f) * 100'003 + round);
      const std::string bytes = fuzzer.mutated(files[f].second);
      const bool misnamed = fuzzer.below(10) == 0;
      read += survives(misnamed ? kNames[fuzzer.below(std::size(kNames))] : files[f].first, bytes);
      ++tried;
      ASSERT_LT(peak_memory_kib() - before, kMostKib);
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(read, tried / 20);      // the damage is fine enough to reach the payload
  EXPECT_LT(read, tried * 9 / 10);  // and coarse enough to be seen
}

}  // namespace
}  // namespace arcbid
