// SPDX-License-Identifier: GPL-3.0-or-later
// `arcbid plan` and `arcbid certify`, from the command line to the files.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr double limit_s = 100;

/// Plans and gives the certificate.
json planned(const std::vector<std::string>& arguments, const std::filesystem::path& out) {
  std::vector<std::string> all{"plan"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--out", out.string()});
  Launched plan(all);
  EXPECT_EQ(plan.wait_for_end(limit_s), 0) << plan.output();
  const json certificate = read_json(out / "certificate.json");
  EXPECT_TRUE(certificate.is_object()) << plan.output();
  EXPECT_EQ(certificate.value("keeps_clear", false), true);
  EXPECT_THAT(plan.output(), HasSubstr("coverage"));
  return certificate;
}

TEST(Plan, OfTheBuiltInBridgeIsARunDirectory) {
  const Scratch scratch;
  const auto out = scratch / "plan";
  const json certificate = planned({}, out);
  EXPECT_GE(certificate["coverage_of_visible"], 0.999);
  EXPECT_GT(certificate["surface_samples"], 10000);
  EXPECT_EQ(certificate["safety_m"], 2.0);
  expect_checked(read_json(out / "result.json"), 4);
  for (const char* file : {"config.yaml", "arcs.json", "structure.ply", "routes.svg",
                           "routes/agent_4.json", "certificate_samples.bin"})
    EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"check", out.string()},
        {"replay", out.string(), "--verify"},
        {"report", out.string(), "--data", (out / "data.json").string()}}) {
    Launched again(command);
    EXPECT_EQ(again.wait_for_end(limit_s), 0) << command[0] << ": " << again.output();
  }
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Plan, CertifiedAgainIsTheSame) {
  const Scratch scratch;
  const auto out = scratch / "plan";
  json first = planned({"--agents", "2", "--sensor", "camera"}, out);
  EXPECT_EQ(first["sensor"]["kind"], "camera");
  const auto samples = bytes_of(out / "certificate_samples.bin");
  std::filesystem::remove(out / "certificate.json");
  std::filesystem::remove(out / "certificate_samples.bin");
  Launched again({"certify", out.string()});
  EXPECT_EQ(again.wait_for_end(limit_s), 0) << again.output();
  EXPECT_EQ(bytes_of(out / "certificate_samples.bin"), samples);
  json second = read_json(out / "certificate.json");
  first.erase("seconds");
  second.erase("seconds");
  EXPECT_EQ(first, second);
}

TEST(Plan, AStructureThatIsGoneIsOneClearLine) {
  const Scratch scratch;
  const auto out = scratch / "plan";
  const auto ply = scratch.file("plate.xyz", [] {
    std::string text;
    for (int x = 0; x < 40; ++x)
      for (int z = 0; z < 40; ++z)
        text += std::to_string(0.25 * x) + " 0 " + std::to_string(0.25 * z) + "\n";
    return text;
  }());
  planned({ply.string(), "--agents", "1"}, out);
  std::filesystem::rename(ply, scratch / "elsewhere.xyz");
  Launched gone({"certify", out.string()});
  EXPECT_EQ(gone.wait_for_end(limit_s), 2);
  EXPECT_THAT(gone.output(), HasSubstr("structure.file: no such file"));
  Launched found({"certify", out.string(), "--structure", (scratch / "elsewhere.xyz").string()});
  EXPECT_THAT(found.wait_for_end(limit_s), ::testing::Eq(0)) << found.output();
}

TEST(Plan, BadInputIsOneLineAndExitCode2) {
  const Scratch scratch;
  const auto full = scratch.file("x", "").parent_path();
  for (const auto& [arguments, said] :
       std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"plan", "--out", full.string()}, "is not empty"},
           {{"plan", "--unit", "cm", "--out", (full / "o").string()}, "none is named"},
           {{"plan"}, "--out"},
           {{"certify", full.string()}, "config.yaml: missing"}}) {
    Launched bad(arguments);
    EXPECT_EQ(bad.wait_for_end(limit_s), 2) << bad.output();
    EXPECT_THAT(bad.output(), HasSubstr(said));
  }
}

TEST(Plan, OfATruss) {
  const std::string truss = shared_data("geometry/bridges/truss_span_48m.ply");
  if (!std::filesystem::exists(truss)) GTEST_SKIP() << truss << " is not here";
  const Scratch scratch;
  const json certificate = planned({truss}, scratch / "plan");
  EXPECT_GE(certificate["coverage_of_visible"], 0.995);
  EXPECT_GT(certificate["visible_samples"], 20000);
}

}  // namespace
}  // namespace arcbid::testing
