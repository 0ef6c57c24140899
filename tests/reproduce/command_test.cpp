// SPDX-License-Identifier: GPL-3.0-or-later
// `arcbid reproduce` as a user meets it.
#include <gmock/gmock.h>
// Last but one: the system headers that it takes in define names that others use.
#include <httplib.h>

#include <algorithm>
#include <fstream>

#include "tests/end_to_end/launched.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void expect_refused(std::vector<std::string> words, const std::string& line) {
  words.insert(words.begin(), "reproduce");
  Launched run(words);
  EXPECT_EQ(run.wait_for_end(20), 2) << run.output();
  EXPECT_THAT(run.output(), HasSubstr(line));
  EXPECT_EQ(std::count(run.output().begin(), run.output().end(), '\n'), 1) << run.output();
}

TEST(Reproduce, RefusesWhatItCannotDoBeforeItBegins) {
  const Scratch scratch;
  const std::string out = (scratch / "out").string();
  expect_refused({"fig9", "--out", out},
                 "'fig9' is no experiment; legal: all, table1, table2, fig5");
  expect_refused({"table2", "--out", out, "--repeats", "0"}, "--repeats");
  expect_refused({"table2"}, "--out is required");
  expect_refused({"table2", "--out", out, "--tsplib", (scratch / "nowhere").string()},
                 "has no att48.tsp, eil101.tsp");
  EXPECT_FALSE(std::filesystem::exists(out));
  scratch.file("occupied.txt", "");
  expect_refused({"fig7", "--out", (scratch / "").string()}, "is not empty; legal is a directory");
}

TEST(Reproduce, LeavesTablesPlotsAndAPageThatViewServes) {
  const Scratch scratch;
  const std::string out = (scratch / "out").string();
  Launched run({"reproduce", "fig7", "--out", out, "--repeats", "1", "--jobs", "2"});
  ASSERT_EQ(run.wait_for_end(200), 0) << run.output();
  EXPECT_THAT(run.output(), HasSubstr("fig7                8 rows"));
  EXPECT_THAT(text_of(scratch / "out/fig7.csv"), ::testing::StartsWith("agents,method,tasks,"));
  EXPECT_THAT(text_of(scratch / "out/report.md"),
              HasSubstr("`arcbid reproduce fig7 --repeats 1 --seed 1 --out DIR`"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "out/fig7.gp"));
  const std::string page = text_of(scratch / "out/index.html");
  EXPECT_EQ(page.find("data:image/svg+xml") != std::string::npos,
            std::filesystem::exists(scratch / "out/fig7.svg"));

  Launched view({"view", out});
  ASSERT_TRUE(view.wait_for("until Ctrl-C", 20)) << view.output();
  const std::string said = view.output();
  const std::size_t at = said.find("http://");
  ASSERT_NE(at, std::string::npos) << said;
  httplib::Client client(said.substr(at, said.find("/ until") - at));
  const auto answer = client.Get("/");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->body, page);
  const auto data = client.Get("/data");
  ASSERT_TRUE(data);
  EXPECT_EQ(data->status, 404);
}

}  // namespace
}  // namespace arcbid::testing
