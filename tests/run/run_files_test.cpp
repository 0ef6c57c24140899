// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

TEST(WriteWhole, ReplacesAFileAtOnceAndLeavesNothingBeside) {
  std::string name = (std::filesystem::temp_directory_path() / "arcbid-run-XXXXXX").string();
  const std::filesystem::path directory = mkdtemp(name.data());
  write_whole(directory / "new" / "file.json", "one");
  write_whole(directory / "new" / "file.json", "two");
  std::stringstream text;
  text << std::ifstream(directory / "new" / "file.json").rdbuf();
  EXPECT_EQ(text.str(), "two");
  EXPECT_FALSE(std::filesystem::exists(directory / "new" / "file.json.part"));
  std::filesystem::remove_all(directory);
}

TEST(WriteWhole, SaysWhichFileCannotBeWritten) {
  try {
    write_whole("/proc/no/such/file.json", "x");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/proc/no/such/file.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace arcbid
