// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_log_reader.hpp"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <fstream>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RunLogReaderTest : public ::testing::Test {
 protected:
  RunLogReaderTest() {
    std::string name = (std::filesystem::temp_directory_path() / "arcbid-read-XXXXXX").string();
    folder = mkdtemp(name.data());
    file = folder / "log.sqlite";
  }
  ~RunLogReaderTest() override { std::filesystem::remove_all(folder); }

  void write_three(int schema = RunLog::schema) const {
    RunLog log(file);
    log.meta("schema", schema);
    log.append(10, "lost", {{"n", 1}});
    log.append(20, log.kind({"step", "cdr", "uint8 n\n"}), std::string("\0\1\0\0\7", 5));
    log.append(30, "lost", {{"n", 2}});
  }
  std::string problem() const {
    try {
      RunLogReader reader(file);
      reader.read([](const auto&) { return true; });
    } catch (const InputError& error) {
      return error.what();
    }
    return "read";
  }

  std::filesystem::path folder, file;
};

TEST_F(RunLogReaderTest, ReadsRecordsInTheirOrderBytesAsTheyWere) {
  write_three();
  std::vector<std::string> seen;
  RunLogReader(file).read([&](const RunLogReader::Record& record) {
    seen.push_back(std::to_string(record.seq) + " " + std::to_string(record.t_ns) + " " +
                   std::string(record.kind) + " " + std::string(record.body));
    return true;
  });
  EXPECT_THAT(seen, ElementsAre("1 10 lost {\"n\":1}", std::string("2 20 step \0\1\0\0\7", 15),
                                "3 30 lost {\"n\":2}"));
}

TEST_F(RunLogReaderTest, BeginsWhereItIsToldAndStopsWhenItIsTold) {
  write_three();
  std::vector<std::int64_t> seen;
  const RunLogReader reader(file);
  reader.read([&](const auto& record) { return seen.push_back(record.seq), false; }, 2);
  EXPECT_THAT(seen, ElementsAre(2));
  seen.clear();
  reader.read([&](const auto& record) { return seen.push_back(record.seq), true; }, 2, "lost");
  EXPECT_THAT(seen, ElementsAre(3));
  EXPECT_EQ(reader.last_ns(), 30);
  EXPECT_EQ(reader.last_seq(), 3);
  EXPECT_EQ(reader.first("lost")->json()["n"], 1);
  EXPECT_FALSE(reader.first("agreed").has_value());
}

TEST_F(RunLogReaderTest, RefusesWhatIsNoLogInOneLine) {
  EXPECT_THAT(problem(), HasSubstr("log.sqlite: is not a readable event log"));
  std::ofstream(file) << "not a database at all, whatever its name may say of it";
  EXPECT_THAT(problem(), HasSubstr("log.sqlite: is not a readable event log: file is not a database"));
}

TEST_F(RunLogReaderTest, SaysWhichSchemaItReads) {
  write_three(1);
  EXPECT_THAT(problem(), HasSubstr("its schema is 1, this arcbid reads 2"));
}

}  // namespace
}  // namespace arcbid
