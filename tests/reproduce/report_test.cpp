// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/report.hpp"

#include <gmock/gmock.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fstream>

#include "core/base/error.hpp"
#include "tests/end_to_end/launched.hpp"

namespace arcbid::reproduce {
namespace {

using arcbid::testing::Scratch;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Picture two_lines() {
  const Series falling{"it's falling", {{{2, 9}, {3, 5}, {4, 2}}}, true, true, 0};
  const Series steps{"steps", {{{2, 1}, {3, 1}}, {{3, 2}, {4, 2}}}, true, true, 1};
  const Series hidden{"nothing", {{}}, true, true, 2};
  return {"chart",
          "A chart",
          1,
          {{"a_b", "N", "seconds", {falling, steps, hidden}}, {"empty", "N", "seconds", {hidden}}}};
}

Finding finding() {
  return {
      .name = "fig0",
      .title = "Fig. 0",
      .setting = "On <paper>.",
      .table = {{{"name", "name", 0}, {"gap_percent", "gap (%)", 2}, {"paper_s", "paper (s)", 1}},
                {{std::string("a, \"b\""), 1.0 / 3, Cell()}, {std::string("c"), 2.0, 71.748}}},
      .pictures = {two_lines()},
      .differences = {"Because `x` < y."}};
}

TEST(Report, MarkdownSetsNumbersSideBySide) {
  const std::string text = markdown({finding()}, "arcbid reproduce", true);
  EXPECT_THAT(text, HasSubstr("| name | gap (%) | paper (s) |\n|---|---:|---:|\n"
                              "| a, \"b\" | 0.33 |  |\n| c | 2.00 | 71.7 |\n"));
  EXPECT_THAT(text, AllOf(HasSubstr("## Fig. 0\n\nOn <paper>."), HasSubstr("![A chart](chart.svg)"),
                          HasSubstr("- Because `x` < y.\n"), HasSubstr("`arcbid reproduce`")));
  EXPECT_THAT(markdown({finding()}, "", false), Not(HasSubstr("chart.svg")));
}

TEST(Report, NumbersAreRoundedAndNothingHasNoSign) {
  EXPECT_EQ(shown(-0.004, {"a", "a", 2}), "0.00");
  EXPECT_EQ(shown(-0.006, {"a", "a", 2}), "-0.01");
  EXPECT_EQ(shown(-0.4, {"a", "a", 0}), "0");
  EXPECT_EQ(shown(1e6, {"a", "a", 0}), "1000000");
  EXPECT_EQ(shown(Cell(), {"a", "a", 2}), "");
}

TEST(Report, CsvReadsBackToTheSameBits) {
  const Scratch scratch;
  write_csv(finding().table, scratch / "t.csv");
  EXPECT_EQ(text_of(scratch / "t.csv"),
            "name,gap_percent,paper_s\r\n\"a, \"\"b\"\"\",0.3333333333333333,\r\nc,2,71.748\r\n");
  EXPECT_EQ(std::stod("0.3333333333333333"), 1.0 / 3);
}

TEST(Report, HtmlNeedsNothingElse) {
  const Scratch scratch;
  scratch.file("chart.svg", "<svg/>");
  const std::string page = html({finding()}, "arcbid reproduce", scratch / "");
  EXPECT_THAT(page,
              AllOf(HasSubstr("On &lt;paper&gt;."), HasSubstr("Because <code>x</code> &lt; y."),
                    HasSubstr("<td class=\"number paper\">71.7</td>"),
                    HasSubstr("src=\"data:image/svg+xml;base64,PHN2Zy8+\""),
                    HasSubstr("default-src 'none'"), Not(HasSubstr("http:"))));
  EXPECT_THAT(html({finding()}, "", scratch / "elsewhere"), Not(HasSubstr("<img")));
}

/// Marks that are drawn; those that are only there to be used have no colour.
std::size_t marks(const boost::property_tree::ptree& tree) {
  std::size_t count = 0;
  for (const auto& [key, child] : tree)
    count +=
        (key == "use" && child.get_optional<std::string>("<xmlattr>.color") ? 1 : 0) + marks(child);
  return count;
}

TEST(Plots, AreWellFormedAndHaveEveryPoint) {
  const Scratch scratch;
  scratch.file("chart.gp", gnuplot_script(two_lines()));
  if (!draw(scratch / "", "chart.gp")) GTEST_SKIP() << "there is no gnuplot";
  boost::property_tree::ptree svg;
  boost::property_tree::read_xml((scratch / "chart.svg").string(), svg);
  // A mark a point, and one a line in the key: 3 + 4 points, 2 lines.
  EXPECT_EQ(marks(svg), 3u + 4 + 2);
  const std::string text = text_of(scratch / "chart.svg");
  EXPECT_THAT(text, AllOf(HasSubstr("it's falling"), HasSubstr("a_b"), HasSubstr("seconds"),
                          Not(HasSubstr("nothing"))));
}

TEST(Plots, ThatCannotBeDrawnAreAnError) {
  const Scratch scratch;
  scratch.file("good.gp", gnuplot_script(two_lines()));
  if (!draw(scratch / "", "good.gp")) GTEST_SKIP() << "there is no gnuplot";
  EXPECT_THROW(draw(scratch / "", "missing.gp"), RunError);
}

}  // namespace
}  // namespace arcbid::reproduce
