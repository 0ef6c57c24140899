// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.hpp"
#include "core/io/tsplib/tsplib.hpp"

namespace arcbid {
namespace {

using testing::HasSubstr;

constexpr const char* kFourCities =
    "NAME : four\nTYPE: TSP\nDIMENSION : 4\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n"
    "1 0 0\n2 3 4\n 3 1.5e1 -2\r\n4 0 7\nEOF\n";

class TsplibReader : public testing::Test {
 protected:
  TsplibReader()
      : folder_(std::filesystem::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
  }
  ~TsplibReader() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  PairedCities read(const std::string& tsp, const std::string& pairs) const {
    return read_paired_cities(file("a.tsp", tsp), file("a.pairs", pairs));
  }
  std::string refusal(const std::string& tsp, const std::string& pairs) const {
    try {
      read(tsp, pairs);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

TEST_F(TsplibReader, JoinsCitiesToArcs) {
  const PairedCities read_cities = read(kFourCities, "# two arcs\n1 2\n\n4 3\n");
  ASSERT_EQ(read_cities.arcs.size(), 2U);
  EXPECT_EQ(read_cities.arcs[0].last_m, Vec3(3, 4, 0));
  EXPECT_EQ(read_cities.arcs[0].length_m, 5);
  EXPECT_EQ(read_cities.arcs[1].first_m, Vec3(0, 7, 0));
  EXPECT_EQ(read_cities.arcs[1].last_m, Vec3(15, -2, 0));
  EXPECT_THAT(read_cities.pairs[1], testing::ElementsAre(4, 3));
}

TEST_F(TsplibReader, ADuplicateIsACity) {
  const auto three = "DIMENSION: 3\nNODE_COORD_SECTION\n1 0 0\n2 3 4\n3 9 9\n";
  const PairedCities read_cities = read(three, "# node 4 is a duplicate of node 2\n1 2\n3 4\n");
  EXPECT_EQ(read_cities.arcs[1].last_m, Vec3(3, 4, 0));
}

TEST_F(TsplibReader, SaysWhatIsWrongAndWhere) {
  const auto missing = folder_ / "absent.tsp";
  EXPECT_THROW(read_paired_cities(missing, file("a.pairs", "1 2\n")), InputError);
  EXPECT_THAT(refusal("TYPE: TSP\nEDGE_WEIGHT_SECTION\n1 2\n", "1 2\n"),
              HasSubstr("a.tsp: no NODE_COORD_SECTION"));
  EXPECT_THAT(refusal("NODE_COORD_SECTION\nEOF\n", ""), HasSubstr("a.tsp: no city"));
  EXPECT_THAT(refusal("DIMENSION: 3\nNODE_COORD_SECTION\n1 0 0\n2 0 1\n", "1 2\n"),
              HasSubstr("a.tsp: DIMENSION is 3, but 2 cities follow"));
  EXPECT_THAT(refusal("NODE_COORD_SECTION\n1 0 0\n1 0 1\n", "1 2\n"),
              HasSubstr("a.tsp:3: city 1 is there twice"));
  EXPECT_THAT(refusal("NODE_COORD_SECTION\n1 0 nan\n", "1 2\n"), HasSubstr("a.tsp:2: 'nan'"));
  EXPECT_THAT(refusal("NODE_COORD_SECTION\n1 0 x\n", "1 2\n"), HasSubstr("a.tsp:2: 'x'"));
  EXPECT_THAT(refusal("NODE_COORD_SECTION\n1 0\n", "1 2\n"), HasSubstr("a.tsp:2: 2 words"));
  EXPECT_THAT(refusal("NODE_COORD_SECTION\n0 0 0\n", "1 2\n"), HasSubstr("a.tsp:2: '0'"));
}

TEST_F(TsplibReader, SaysWhatIsWrongWithPairs) {
  EXPECT_THAT(refusal(kFourCities, "1 2\n3 5\n"),
              HasSubstr("a.pairs:2: there is no city 5; legal: 1 to 4"));
  EXPECT_THAT(refusal(kFourCities, "1 2\n3 2\n"),
              HasSubstr("a.pairs:2: city 2 is in a pair already"));
  EXPECT_THAT(refusal(kFourCities, "1 1\n"), HasSubstr("a.pairs:1: city 1 is in a pair already"));
  EXPECT_THAT(refusal(kFourCities, "1 2 3\n"), HasSubstr("a.pairs:1: 3 words"));
  EXPECT_THAT(refusal(kFourCities, "1 -2\n"), HasSubstr("a.pairs:1: '-2'"));
  EXPECT_THAT(refusal(kFourCities, "1 2\n"), HasSubstr("a.pairs: city 3 is in no pair"));
  EXPECT_THAT(refusal(kFourCities, "# node 9 is a duplicate of node 8\n1 2\n3 4\n"),
              HasSubstr("a.pairs:1: there is no city 8"));
  EXPECT_THAT(refusal(kFourCities, "# node 3 is a duplicate of node 1\n1 2\n3 4\n"),
              HasSubstr("a.pairs:1: city 3 is there already"));
}

}  // namespace
}  // namespace arcbid
