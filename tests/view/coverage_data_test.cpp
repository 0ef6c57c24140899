// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "sim/view/base64.hpp"
#include "sim/view/sample_file.hpp"
#include "sim/view/view_data.hpp"
#include "tests/view/coverage_files.hpp"
#include "tests/view/recorded_world.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::vector<FiledSample> few{
    {{1, 2, 3}, {0, 0, 127}, 0, 1},     {{1, 2, 3}, {0, 0, -127}, 8, 0},
    {{4, 5, 6}, {127, 0, 0}, 0, 4},     {{4, 5, 6}, {-127, 0, 0}, 1, 0},
    {{7, 8, 9.5f}, {0, 127, 0}, 0, 33}, {{7, 8, 9.5f}, {0, -127, 0}, 0, 40000}};

class CoverageDataTest : public ::testing::Test {
 protected:
  CoverageDataTest() { write(samples_file(few), certificate_file(few.size())); }
  void write(const std::string& samples, const json& certificate) {
    write_file(folder.path / "certificate_samples.bin", samples);
    write_file(folder.path / "certificate.json", certificate.dump());
  }
  json data() const { return coverage_data(folder.path); }
  std::string problem() const { return data().value("problem", "none"); }
  Folder folder;
};

template <class T>
std::string packed(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

TEST_F(CoverageDataTest, CarriesTheFigures) {
  const json coverage = data();
  EXPECT_FALSE(coverage.contains("problem")) << coverage["problem"];
  const json certificate = certificate_file(few.size());
  for (const char* figure :
       {"surface_samples", "visible_samples", "covered_samples", "covered_visible_samples",
        "coverage_of_visible", "coverage_of_total", "spacing_m", "flown_m", "metres_per_m2",
        "safety_m", "tolerance_m", "min_clearance_m", "below_floor_m", "uncovered", "clearance"})
    EXPECT_EQ(coverage[figure], certificate[figure]) << figure;
}

TEST_F(CoverageDataTest, CarriesEverySampleOfFew) {
  const json samples = data()["samples"];
  EXPECT_EQ(samples["total"], 6);
  EXPECT_EQ(samples["classes"], json({4, 1, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(samples["stretches"], json({1, 0, 1, 0, 0, 0, 2}));
  const std::vector<float> positions{1, 2, 3, 1, 2, 3, 4, 5, 6, 4, 5, 6, 7, 8, 9.5f, 7, 8, 9.5f};
  EXPECT_EQ(samples["positions"], packed(positions));
  const std::vector<std::int8_t> normals{0,    0, 127, 0, 0,   -127, 127, 0,    0,
                                         -127, 0, 0,   0, 127, 0,    0,   -127, 0};
  EXPECT_EQ(samples["normals"], packed(normals));
  EXPECT_EQ(samples["class"], packed(std::vector<std::uint8_t>{0, 8, 0, 1, 0, 0}));
  EXPECT_EQ(samples["seen_by"], packed(std::vector<std::uint16_t>{1, 0, 4, 0, 33, 40000}));
}

TEST_F(CoverageDataTest, BinsBySharesOfTwo) {
  std::vector<FiledSample> samples;
  for (const std::uint16_t times : {1, 2, 3, 4, 5, 8, 9, 16, 17, 32, 33, 65535})
    samples.push_back({{}, {0, 0, 127}, 0, times});
  write(samples_file(samples), certificate_file(samples.size()));
  EXPECT_EQ(data()["samples"]["stretches"], json({1, 1, 2, 2, 2, 2, 2}));
}

TEST_F(CoverageDataTest, IsNothingWhereThereIsNoCertificate) {
  std::filesystem::remove(folder.path / "certificate.json");
  EXPECT_EQ(problem(), "certificate.json: the file is missing");
  std::filesystem::remove(folder.path / "certificate_samples.bin");
  EXPECT_TRUE(data().is_null());
}

TEST_F(CoverageDataTest, KeepsTheFiguresWhereTheSamplesAreDamaged) {
  const std::string whole = samples_file(few);
  const auto problem_of = [this](std::string bytes) {
    write(bytes, certificate_file(few.size()));
    EXPECT_EQ(data()["covered_samples"], 4);
    EXPECT_FALSE(data().contains("samples"));
    return problem();
  };
  EXPECT_EQ(problem_of(""),
            "certificate_samples.bin: does not begin with ARCBSMPL and two numbers");
  EXPECT_THAT(problem_of("PLY" + whole), HasSubstr("does not begin with ARCBSMPL"));
  EXPECT_THAT(problem_of(whole.substr(0, 15)), HasSubstr("does not begin with ARCBSMPL"));
  EXPECT_EQ(problem_of(whole.substr(0, whole.size() - 1)),
            "certificate_samples.bin: 135 bytes, must be 136 for its 6 samples");
  EXPECT_THAT(problem_of(whole + "x"), HasSubstr("137 bytes, must be 136"));
  std::string other = whole;
  other[8] = 2;
  EXPECT_THAT(problem_of(other), HasSubstr("version is 2, must be 1"));
  auto samples = few;
  samples[3].fate = 9;
  EXPECT_THAT(problem_of(samples_file(samples)), HasSubstr("sample 3: class is 9, must be 0 to 8"));
  samples = few;
  samples[5].position_m[1] = std::numeric_limits<float>::infinity();
  EXPECT_THAT(problem_of(samples_file(samples)),
              HasSubstr("sample 5: position is inf, must be finite"));
  std::filesystem::remove(folder.path / "certificate_samples.bin");
  EXPECT_EQ(problem(), "certificate_samples.bin: the file is missing");
  std::filesystem::create_directory(folder.path / "certificate_samples.bin");
  EXPECT_EQ(problem(), "certificate_samples.bin: not a regular file");
}

TEST_F(CoverageDataTest, RefusesSamplesOfAnotherCertificate) {
  write(samples_file(few), certificate_file(7));
  EXPECT_EQ(problem(), "certificate_samples.bin: 6 samples, must be 7 as in certificate.json");
}

TEST_F(CoverageDataTest, NamesTheFieldOfADamagedCertificate) {
  const auto problem_with = [this](const char* field, const json& value) {
    json certificate = certificate_file(few.size());
    certificate[json::json_pointer(field)] = value;
    write(samples_file(few), certificate);
    EXPECT_FALSE(data().contains("samples"));
    return problem();
  };
  EXPECT_EQ(problem_with("/schema", 2), "certificate.json: schema is 2, must be 1");
  EXPECT_THAT(problem_with("/covered_samples", -1), HasSubstr("covered_samples is -1"));
  EXPECT_EQ(problem_with("/safety_m", -2.0),
            "certificate.json: safety_m is -2.0, must be 0 or more");
  EXPECT_THAT(problem_with("/spacing_m", nullptr), HasSubstr("spacing_m is null"));
  EXPECT_THAT(problem_with("/uncovered/0/reason", 3), HasSubstr("uncovered[0].reason is 3"));
  EXPECT_THAT(problem_with("/clearance/0/nearest/at_m", {1, 2}), HasSubstr("three numbers"));
  EXPECT_THAT(problem_with("/clearance", "none"), HasSubstr("clearance is \"none\""));
}

TEST_F(CoverageDataTest, CanAlwaysBeSentOn) {
  for (const std::string bytes : {"", "{\"schema\": 1", "\xff\xfe{", "[1, 2]", "null", "{\n\xc3"}) {
    write_file(folder.path / "certificate.json", bytes);
    const json coverage = data();
    EXPECT_THAT(coverage.value("problem", ""), ::testing::StartsWith("certificate.json: "));
    EXPECT_THAT(coverage.dump(), ::testing::Not(HasSubstr("\n")));
  }
}

TEST_F(CoverageDataTest, IsPartOfTheViewDataWhateverBecameOfIt) {
  const auto run = folder.path / "run";
  record_world(PolicyKind::claims, 3, run);
  EXPECT_FALSE(view_data(open_run(run)).contains("coverage"));
  write_file(run / "certificate.json", certificate_file(few.size()).dump());
  write_file(run / "certificate_samples.bin", samples_file(few));
  EXPECT_EQ(view_data(open_run(run))["coverage"]["samples"]["total"], 6);
  write_file(run / "certificate.json", "damaged");
  const json data = view_data(open_run(run));
  EXPECT_THAT(data["coverage"]["problem"], HasSubstr("not JSON"));
  EXPECT_EQ(data["mission"]["routes"].size(), 5u);
}

/// 60 covered samples, 30 occluded ones, 3 that were missed.
std::vector<FiledSample> many() {
  std::vector<FiledSample> out;
  for (int i = 0; i < 93; ++i) {
    const auto fate = static_cast<std::uint8_t>(i % 31 == 7 ? 1 : i % 3 == 2 ? 8 : 0);
    out.push_back({{static_cast<float>(i), 0, 0}, {0, 0, 127}, fate, 1});
  }
  return out;
}

TEST_F(CoverageDataTest, ThinsEvenlyAndKeepsWhatIsRareWhole) {
  const auto file = folder.path / "certificate_samples.bin";
  write_file(file, samples_file(many()));
  const ShownSamples all = read_samples(file, 93);
  EXPECT_EQ(all.fate.size(), 93u);
  const ShownSamples thin = read_samples(file, 60);
  EXPECT_EQ(thin.fate.size(), 60u);
  EXPECT_EQ(thin.total, 93u);
  EXPECT_EQ(thin.fates, all.fates) << "counts are of all";
  EXPECT_EQ(thin.bins, all.bins);
  EXPECT_EQ(std::count(thin.fate.begin(), thin.fate.end(), 1), 3) << "rare: none is lost";
  EXPECT_NEAR(std::count(thin.fate.begin(), thin.fate.end(), 8), 30 * 57 / 90, 4);
  for (std::size_t i = 1; i < 60; ++i)
    EXPECT_GT(thin.positions_m[3 * i], thin.positions_m[3 * i - 3]) << "each once, in order";
}

TEST_F(CoverageDataTest, ShowsBothSidesWhereTheyAlternate) {
  std::vector<FiledSample> samples;
  for (int i = 0; i < 100; ++i)
    samples.push_back({{}, {0, 0, static_cast<std::int8_t>(i % 2 == 0 ? 127 : -127)}, 0, 1});
  const auto file = folder.path / "certificate_samples.bin";
  write_file(file, samples_file(samples));
  const ShownSamples half = read_samples(file, 50);
  EXPECT_NEAR(std::count(half.normals.begin(), half.normals.end(), 127), 25, 5);
}

}  // namespace
}  // namespace arcbid::testing
