// SPDX-License-Identifier: GPL-3.0-or-later
// A real run, exported as a user does it, and read with other people's readers.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/io/structure_reader.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/mcap/read_back.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

TEST(ExportOfARealRun, IsReadByOthersAndReplacesNothingUnasked) {
  const Scratch scratch;
  const std::string out = scratch / "run", mcap = scratch / "run.mcap", csv = scratch / "csv";
  Launched run({"run", demo_config(), "--out", out});
  ASSERT_EQ(run.wait_for_end(60), 0) << run.output();
  Launched first({"export", out, "--mcap", mcap, "--csv", csv});
  ASSERT_EQ(first.wait_for_end(30), 0) << first.output();
  Launched second({"export", out, "--csv", csv});
  EXPECT_EQ(second.wait_for_end(30), 2);
  EXPECT_THAT(second.output(),
              HasSubstr("decisions.csv: exists; name another, or replace it with --force"));
  Launched third({"export", out, "--mcap", mcap});
  EXPECT_EQ(third.wait_for_end(30), 2);
  EXPECT_THAT(third.output(), HasSubstr("run.mcap: exists"));
  Launched forced({"export", out, "--mcap", mcap, "--csv", csv, "--force"});
  EXPECT_EQ(forced.wait_for_end(30), 0) << forced.output();

  if (!std::filesystem::exists(ARCBID_MCAP_READER_FILE))
    GTEST_SKIP() << "the readers of MCAP files are not installed";
  const auto [exit_code, said] = mcap_test::read(mcap);
  EXPECT_EQ(exit_code, 0) << said.at("errors");
  std::map<std::string, std::size_t> messages;
  for (const auto& channel : said.at("channels"))
    messages[channel.at("topic")] = channel.at("messages");
  EXPECT_EQ(messages.size(), 5 + 4 * 7u);
  EXPECT_GE(messages["/events"], 8u);  // four start and agree
  EXPECT_GT(messages["/arcs"], 1u);
  for (int agent = 1; agent <= 4; ++agent)
    for (const char* topic : {"step", "sent/bid", "sent/status", "route", "pose", "tasks_held"})
      EXPECT_GT(messages[fmt::format("/agent_{}/{}", agent, topic)], 0u) << agent << topic;
  const auto& step = said.at("first").at("/agent_3/step");
  EXPECT_EQ(step.at("event").at("tick").size() + step.at("event").at("status").size(), 1u);
  EXPECT_EQ(said.at("attachments").size(), 2u);
  const Structure structure = read_structure(scratch / "run/structure.ply", {}).structure;
  EXPECT_EQ(said.at("first").at("/structure").at("width"), structure.points.size());
  EXPECT_EQ(said.at("first").at("/structure_mesh").at("markers").at(0).at("points").size(),
            3 * structure.triangles.size());
}

}  // namespace
}  // namespace arcbid::testing
