// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rules/rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

namespace arcbid::rules {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Files& repository() {
  static const Files files = read_tree(ARCBID_SOURCE_DIR);
  return files;
}

/// A rule on the repository itself, all violations in the message.
void expect_holds(Violations (*rule)(const Files&)) {
  const Violations violations = rule(repository());
  EXPECT_TRUE(violations.empty()) << fmt::format("{}", fmt::join(violations, "\n"));
}

TEST(Repository, IsRead) {
  std::vector<std::string> paths;
  for (const SourceFile& file : repository()) paths.push_back(file.path);
  EXPECT_THAT(paths, testing::IsSupersetOf({"CMakeLists.txt", "core/arcs/arc.hpp", "idl/bus.hpp",
                                            "tests/rules/rules_test.cpp"}));
}
TEST(Repository, IncludesFollowTheLayers) {
  expect_holds(include_layers);
}
TEST(Repository, LinksFollowTheLayers) {
  expect_holds(link_layers);
}
TEST(Repository, CoreIsArithmetic) {
  expect_holds(core_is_arithmetic);
}
TEST(Repository, RandomnessIsPortable) {
  expect_holds(no_library_dependent_randomness);
}
TEST(Repository, GeometryLibrariesStayInCore) {
  expect_holds(geometry_libraries_stay_in_core);
}
TEST(Repository, CheckerIsIndependent) {
  expect_holds(checker_is_independent);
}
TEST(Repository, CertificateIsIndependent) {
  expect_holds(certificate_is_independent);
}
TEST(Repository, EverySourceHasItsLicenseLine) {
  expect_holds(license_line);
}
TEST(Repository, NamesNoRegistryHost) {
  expect_holds(no_registry_hosts);
}
TEST(Repository, MarksNameAnIssue) {
  expect_holds(marks_name_an_issue);
}

// Each rule bites: made-up sources that break it, and their legal neighbours that do not.

TEST(Rules, EveryForbiddenIncludeEdgeIsSeen) {
  const std::vector<std::string> layers = {"core", "idl", "agent", "coordinator", "sim"};
  const std::vector<std::string> legal = {"idl>core",        "agent>idl",        "agent>core",
                                          "coordinator>idl", "coordinator>core", "sim>core"};
  for (const std::string& from : layers)
    for (const std::string& to : layers) {
      const Files files = {{from + "/a.cpp", "#include \"" + to + "/b.hpp\"\n"}};
      const bool is_legal =
          from == to || std::find(legal.begin(), legal.end(), from + ">" + to) != legal.end();
      EXPECT_EQ(include_layers(files).empty(), is_legal) << from << " -> " << to;
    }
}

TEST(Rules, AForbiddenIncludeIsNamedWithItsLine) {
  EXPECT_THAT(include_layers({{"core/a.hpp", "#pragma once\n#  include <idl/bus.hpp>\n"}}),
              ElementsAre("core/a.hpp:2: includes idl/bus.hpp; core must not depend on idl; legal: "
                          "agent, coordinator -> idl -> core <- sim"));
}

TEST(Rules, IncludesThatAreNoEdges) {
  EXPECT_THAT(include_layers({{"core/a.cpp",
                               "#include <vector>\n// #include \"idl/x.hpp\"\n/*\n#include "
                               "\"sim/x.hpp\"\n*/\n#include \"core/b.hpp\"\n"},
                              {"tests/a/a.cpp", "#include \"idl/x.hpp\"\n#include \"sim/x.hpp\"\n"},
                              {"docs/a.md", "#include \"idl/x.hpp\"\n"}}),
              IsEmpty());
}

TEST(Rules, WaysAroundTheLayersAreSeen) {
  EXPECT_THAT(include_layers({{"core/a.cpp", "#include \"../idl/bus.hpp\"\n"}}),
              ElementsAre("core/a.cpp:1: includes ../idl/bus.hpp; legal: the path from the "
                          "repository's root"));
  EXPECT_THAT(include_layers({{"tools/a.cpp", "int x;\n"}}),
              ElementsAre("tools/a.cpp: tools is no known layer; add it to tests/rules/rules.cpp"));
  EXPECT_THAT(include_layers({{"core/tour/a.cpp", "#include \"core/io/config.hpp\"\n"}}),
              ElementsAre("core/tour/a.cpp:1: includes core/io/config.hpp; what decides must not "
                          "depend on core/io"));
}

const SourceFile idl_cmake = {"idl/CMakeLists.txt", "add_library(the_bus STATIC bus.cpp)\n"};
const SourceFile core_cmake = {"core/arcs/CMakeLists.txt",
                               "add_library(the_arcs STATIC arc.cpp)\n"};

TEST(Rules, AForbiddenLinkIsSeen) {
  EXPECT_THAT(
      link_layers({idl_cmake,
                   core_cmake,
                   {"sim/CMakeLists.txt",
                    "add_library(world w.cpp)\n# target_link_libraries(world x)\n"
                    "target_link_libraries(world\n  PUBLIC the_arcs\n  PRIVATE the_bus)\n"}}),
      ElementsAre("sim/CMakeLists.txt:3: world links the_bus; sim must not depend on idl; "
                  "legal: agent, coordinator -> idl -> core <- sim"));
  EXPECT_THAT(
      link_layers({idl_cmake,
                   core_cmake,
                   {"agent/CMakeLists.txt",
                    "add_executable(a m.cpp)\ntarget_link_libraries(a the_bus the_arcs)\n"}}),
      IsEmpty());
}

TEST(Rules, ALinkFromAnotherFoldersFileIsSeen) {
  EXPECT_THAT(link_layers({idl_cmake,
                           core_cmake,
                           {"CMakeLists.txt", "target_link_libraries(the_arcs PUBLIC the_bus)\n"}}),
              testing::SizeIs(1));
}

TEST(Rules, LibrariesThatTouchTheWorldAreSeen) {
  const auto link = [](const std::string& folder, const std::string& library) {
    return link_layers(
        {{folder + "/CMakeLists.txt",
          "add_library(a a.cpp)\ntarget_link_libraries(a PRIVATE " + library + ")\n"}});
  };
  EXPECT_THAT(link("core/io/x", "fastrtps"), testing::SizeIs(1));
  EXPECT_THAT(link("sim", "fastcdr"), testing::SizeIs(1));
  EXPECT_THAT(link("sim/mcap", "fastcdr"), IsEmpty());
  EXPECT_THAT(link("sim/mcap", "fastrtps"), testing::SizeIs(1));
  EXPECT_THAT(link("core/tour", "spdlog::spdlog"), testing::SizeIs(1));
  EXPECT_THAT(link("core/tour", "Threads::Threads"), testing::SizeIs(1));
  EXPECT_THAT(link("core/airspace", "Threads::Threads"), IsEmpty());
  EXPECT_THAT(link("core/arcs", "SQLite::SQLite3"), testing::SizeIs(1));
  EXPECT_THAT(link("core/io/x", "SQLite::SQLite3"), IsEmpty());
  EXPECT_THAT(link("idl", "fastrtps"), IsEmpty());
}

TEST(Rules, EveryHeaderOfTheWorldIsSeenInWhatDecides) {
  for (const std::string header :
       {"thread", "mutex", "fstream", "iostream", "filesystem", "random", "spdlog/spdlog.h",
        "fastdds/dds/domain/DomainParticipant.hpp", "fastrtps/types.h", "sqlite3.h", "unistd.h"})
    for (const std::string module : {"base", "arcs", "auction", "tour", "route", "structure"})
      EXPECT_FALSE(
          core_is_arithmetic({{"core/" + module + "/a.cpp", "#include <" + header + ">\n"}})
              .empty())
          << module << " " << header;
  EXPECT_THAT(core_is_arithmetic({{"core/io/a.cpp", "#include <fstream>\n#include <sqlite3.h>\n"},
                                  {"core/tour/a.cpp", "#include <vector>\n"},
                                  {"core/airspace/a.cpp", "#include <thread>\n"},
                                  {"agent/a.cpp", "#include <thread>\n"}}),
              IsEmpty());
}

TEST(Rules, FastDdsIsSeenInAllOfCoreAndSim) {
  EXPECT_THAT(core_is_arithmetic({{"core/io/a.cpp", "#include <fastdds/x.hpp>\n"},
                                  {"sim/a.cpp", "#include <fastrtps/x.h>\n"},
                                  {"idl/a.cpp", "#include <fastrtps/x.h>\n"}}),
              ElementsAre("core/io/a.cpp:1: includes fastdds/x.hpp; Fast DDS stays in idl and the "
                          "processes",
                          "sim/a.cpp:1: includes fastrtps/x.h; Fast DDS stays in idl and the "
                          "processes"));
}

TEST(Rules, FastCdrServesMcapOnly) {
  const std::string include = "#include <fastcdr/Cdr.h>\n";
  EXPECT_THAT(
      core_is_arithmetic(
          {{"sim/mcap/a.cpp", include}, {"core/io/record/a.cpp", include}, {"idl/a.hpp", include}}),
      IsEmpty());
  for (const std::string file : {"sim/mcap/a.hpp", "sim/a.cpp", "core/io/a.cpp"})
    EXPECT_THAT(core_is_arithmetic({{file, include}}), testing::SizeIs(1)) << file;
}

TEST(Rules, ClocksAreSeen) {
  EXPECT_THAT(
      core_is_arithmetic(
          {{"core/auction/a.cpp",
            "// no steady_clock here\nauto t = std::chrono::steady_clock::now();\n"}}),
      ElementsAre("core/auction/a.cpp:2: steady_clock reads a clock; core gets the time as an "
                  "event's field"));
}

TEST(Rules, LibraryDependentRandomnessIsSeen) {
  for (const std::string word : {"shuffle", "uniform_int_distribution", "normal_distribution",
                                 "random_device", "sample", "rand", "ranges::shuffle"})
    EXPECT_THAT(
        no_library_dependent_randomness({{"sim/a.cpp", "auto x = std::" + word + "(y);\n"}}),
        testing::SizeIs(1))
        << word;
  EXPECT_THAT(
      no_library_dependent_randomness(
          {{"sim/a.cpp", "boost::random::uniform_int_distribution<int> d; std::mt19937_64 r;\n"}}),
      IsEmpty());
}

TEST(Rules, GeometryLibrariesOutsideCoreOrInHeadersAreSeen) {
  EXPECT_THAT(
      geometry_libraries_stay_in_core({{"core/structure/a.hpp", "#include <CGAL/x.h>\n"},
                                       {"core/structure/a.cpp", "#include <CGAL/x.h>\n"},
                                       {"sim/a.cpp", "#include <pcl/x.h>\n"},
                                       {"tests/a/a.cpp", "#include <CGAL/x.h>\n"}}),
      ElementsAre("core/structure/a.hpp:1: includes CGAL/x.h; legal only in .cpp files under core",
                  "sim/a.cpp:1: includes pcl/x.h; legal only in .cpp files under core"));
}

TEST(Rules, ACheckerThatSharesCodeIsSeen) {
  EXPECT_THAT(
      checker_is_independent(
          {{"sim/checker/a.cpp", "#include \"sim/checker/b.hpp\"\n#include \"core/x.hpp\"\n"},
           {"sim/b.cpp", "#include \"core/x.hpp\"\n"}}),
      ElementsAre("sim/checker/a.cpp:2: includes core/x.hpp; the checker shares nothing with "
                  "what it checks"));
  // Through a neighbour, too: sim may use core.
  EXPECT_THAT(checker_is_independent({{"sim/checker/a.cpp", "#include \"sim/b.hpp\"\n"}}),
              testing::SizeIs(1));
  EXPECT_THAT(
      checker_is_independent({core_cmake,
                              {"sim/checker/CMakeLists.txt",
                               "add_library(c c.cpp)\ntarget_link_libraries(c the_arcs)\n"}}),
      testing::SizeIs(1));
}

TEST(Rules, ACertificateThatSharesCodeIsSeen) {
  EXPECT_THAT(
      certificate_is_independent(
          {{"sim/certificate/a.cpp",
            "#include \"sim/certificate/b.hpp\"\n#include \"core/structure/structure.hpp\"\n"
            "#include \"sim/checker/b.hpp\"\n#include \"core/structure/cover.hpp\"\n"}}),
      ElementsAre("sim/certificate/a.cpp:4: includes core/structure/cover.hpp; the "
                  "certificate shares no code with what plans"));
  EXPECT_THAT(
      certificate_is_independent({core_cmake,
                                  {"sim/certificate/CMakeLists.txt",
                                   "add_library(c c.cpp)\ntarget_link_libraries(c the_arcs)\n"}}),
      testing::SizeIs(1));
}

TEST(Rules, AMissingLicenseLineIsSeen) {
  const std::string line = "SPDX-License-Identifier: GPL-3.0-or-later\n";
  for (const std::string path :
       {"core/a.cpp", "core/a.hpp", "CMakeLists.txt", "core/CMakeLists.txt", "configs/a.yaml",
        "idl/a.idl", "a.sh", "viewer/a.ts"}) {
    EXPECT_THAT(license_line({{path, "int x;\n"}}), testing::SizeIs(1)) << path;
    EXPECT_THAT(license_line({{path, "// " + line}}), IsEmpty()) << path;
  }
  EXPECT_THAT(license_line({{"dev", "#!/bin/sh\nset -e\n"}}),
              ElementsAre("dev:1: has no line \"SPDX-License-Identifier: GPL-3.0-or-later\""));
  EXPECT_THAT(license_line({{"dev", "#!/bin/sh\n# " + line}, {"README.md", "words\n"}}), IsEmpty());
}

TEST(Rules, RegistryHostsAreSeen) {
  for (const std::string host : {"deb.debian"
                                 ".org",
                                 "registry.npmjs"
                                 ".org",
                                 "ftp.x.debian"
                                 ".org/debian"})
    EXPECT_THAT(no_registry_hosts({{"package-lock.json", "x\n\"https://" + host + "/y\"\n"}}),
                testing::SizeIs(1))
        << host;
  EXPECT_THAT(no_registry_hosts({{"README.md", "Debian 12, npm\n"}}), IsEmpty());
}

TEST(Rules, MarksWithoutAnIssueAreSeen) {
  const std::string mark =
      "TO"
      "DO";
  EXPECT_THAT(marks_name_an_issue({{"a.cpp", "int x;\n// " + mark + ": later\n"}}),
              ElementsAre("a.cpp:2: " + mark + " without an issue's number (#N)"));
  EXPECT_THAT(marks_name_an_issue({{"a.cpp", "// " + mark + " #12: later\n"}}), IsEmpty());
}

}  // namespace
}  // namespace arcbid::rules
