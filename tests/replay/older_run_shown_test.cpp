// SPDX-License-Identifier: GPL-3.0-or-later
// What others are given of a run of an arcbid whose records are laid out otherwise.
#include "agent/recorded_messages.hpp"
#include "sim/export/csv_export.hpp"
#include "sim/export/mcap_export.hpp"
#include "tests/end_to_end/launched.hpp"
#include "tests/mcap/records_of.hpp"
#include "tests/replay/older_run_fixture.hpp"

namespace arcbid::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> said(const RecordedMessages& messages) {
  std::vector<std::string> out;
  messages.play([&out](TimeNs t_ns, const AgentMessage& message) {
    std::visit(
        [&](auto one) {
          one.header.task_digest = 0;  // which the older build did not write down
          out.push_back(std::to_string(t_ns) + encode(one));
        },
        message);
    return true;
  });
  return out;
}

TEST_F(OlderRun, IsSaidAgainAsItWas) {
  age();
  const RecordedMessages before(was), after(run);
  EXPECT_THAT(after.left_out(), IsEmpty());
  EXPECT_EQ(after.fleet(), before.fleet());
  EXPECT_GT(said(before).size(), 100u);
  EXPECT_EQ(said(after), said(before));
  EXPECT_THAT(before.of_other_builds(), IsEmpty());
  EXPECT_THAT(after.of_other_builds(),
              ElementsAre(AllOf(HasSubstr("agent_1.1001.sqlite and 2 more: agents of this build "
                                          "may refuse its messages: written by arcbid 0.0.9"),
                                HasSubstr("Header.task_digest is not there"))));
}

TEST_F(OlderRun, IsExportedAsItWas) {
  age(otherwise_but_whole);
  const RunArchive before = open_run(was), after = open_run(run);
  ASSERT_EQ(unverifiable(after).size(), 1u);
  export_mcap(before, folder / "before.mcap");
  export_mcap(after, folder / "after.mcap");
  const auto messages = mcap_test::messages_of(folder / "before.mcap");
  EXPECT_GT(messages.size(), 100u);
  EXPECT_EQ(mcap_test::messages_of(folder / "after.mcap"), messages);
  export_csv(before, folder / "before");
  export_csv(after, folder / "after");
  for (const auto& file : csv_files(folder / "before"))
    EXPECT_EQ(bytes_of(folder / "after" / file.filename()), bytes_of(file)) << file;
}

TEST_F(OlderRun, IsToldOfByTheCommands) {
  age();
  Launched verify({"replay", run, "--verify"});
  EXPECT_EQ(verify.wait_for_end(60), 2) << verify.output();
  EXPECT_THAT(verify.output(),
              HasSubstr("plays, but cannot be verified: written by arcbid 0.0.9 01dbeef"));
  Launched explain({"explain", run, "--arc", "0"});
  EXPECT_EQ(explain.wait_for_end(60), 0) << explain.output();
  EXPECT_THAT(explain.output(), AllOf(HasSubstr("and 2 more: plays, but cannot be verified: "),
                                      HasSubstr("has it at the end")));
}

}  // namespace
}  // namespace arcbid::testing
