// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/page.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "core/base/error.hpp"
#include "sim/view/base64.hpp"
#include "tests/view/recorded_world.hpp"

namespace arcbid::testing {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::filesystem::path& programs) {
  try {
    viewer_page(programs);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Page, IsFoundBesideThePrograms) {
  const Folder folder;
  std::filesystem::create_directories(folder.path / "share");
  std::ofstream(folder.path / "share/viewer.html") << "<html><!--arcbid-data--></html>";
  EXPECT_EQ(viewer_page(folder.path / "bin"), "<html><!--arcbid-data--></html>");
}

TEST(Page, SaysWhatItTakesWhereItWasNotBuilt) {
  const Folder folder;
  EXPECT_THAT(refusal(folder.path / "bin"), HasSubstr("viewer.html: the viewer was not built"));
  EXPECT_THAT(refusal(folder.path / "bin"), HasSubstr("install nodejs and npm"));
}

TEST(Page, RefusesAFileWithoutAPlaceForTheRun) {
  const Folder folder;
  std::filesystem::create_directories(folder.path / "share");
  std::ofstream(folder.path / "share/viewer.html") << "<html></html>";
  EXPECT_THAT(refusal(folder.path / "bin"), HasSubstr("is no viewer page"));
}

TEST(Page, HoldsTheRunWhereItsPlaceWas) {
  const std::string page = report_page("a<!--arcbid-data-->b", "{}");
  EXPECT_THAT(page, ::testing::StartsWith(
                        "a<script id=\"arcbid-data\" type=\"application/gzip-base64\">H4sI"));
  EXPECT_THAT(page, ::testing::EndsWith("</script>b"));
}

TEST(Page, EncodesWhatNoLengthDividesByThree) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("a"), "YQ==");
  EXPECT_EQ(base64("ab"), "YWI=");
  EXPECT_EQ(base64("abc"), "YWJj");
}

}  // namespace
}  // namespace arcbid::testing
