// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rules/rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace arcbid::rules {
namespace {

/// Which folders a folder may depend on, itself aside.
const std::map<std::string, std::set<std::string>> legal_edges = {
    {"core", {}},
    {"idl", {"core"}},
    {"agent", {"idl", "core"}},
    {"coordinator", {"idl", "core"}},
    {"sim", {"core"}},
};
const std::set<std::string> free_folders = {"tests", "bench"};  // may depend on everything

const std::vector<std::string> deciding_modules = {
    "core/base/", "core/arcs/",   "core/auction/", "core/faults/",
    "core/tour/", "core/trades/", "core/route/",   "core/structure/"};

bool is_deciding(const std::string& path) {
  return std::any_of(deciding_modules.begin(), deciding_modules.end(),
                     [&](const std::string& module) { return path.starts_with(module); });
}

/// The first folder of a path; empty for files at the root.
std::string layer_of(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

bool may_depend(const std::string& from, const std::string& to) {
  return from == to || free_folders.contains(from) ||
         (legal_edges.contains(from) && legal_edges.at(from).contains(to));
}

std::string forbidden_edge(const std::string& from, const std::string& to) {
  return fmt::format("{} must not depend on {}; legal: agent, coordinator -> idl -> core <- sim",
                     from, to);
}

/// Fast CDR only lays out bytes: files of ROS messages may use it where DDS has no business.
bool may_lay_out_cdr(const std::string& path) {
  return path.starts_with("sim/mcap/") || path.starts_with("core/io/record");
}

/// Geometry may use all processors where the result is the same bit for bit.
bool may_share_out_arithmetic(const std::string& path) {
  return path.starts_with("core/airspace");
}

bool matches(const std::string& text, const char* pattern) {
  return std::regex_search(text, std::regex(pattern));
}

/// Lines that match, each with `what` behind its place.
Violations lines_with(const SourceFile& file, const std::string& text, const std::regex& pattern,
                      const std::string& what) {
  Violations found;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (std::smatch match; std::regex_search(line, match, pattern))
      found.push_back(fmt::format("{}:{}: {} {}", file.path, number, match.str(), what));
  }
  return found;
}

void append(Violations& all, Violations more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Includes that match a pattern, in files that `concerns`.
template <class Concerns>
Violations includes_matching(const Files& files, const char* pattern, const std::string& what,
                             Concerns concerns) {
  Violations found;
  for (const SourceFile& file : files) {
    if (!is_cpp(file.path) || !concerns(file.path)) continue;
    for (const Include& include : includes(file.text))
      if (matches(include.name, pattern))
        found.push_back(
            fmt::format("{}:{}: includes {}; {}", file.path, include.line, include.name, what));
  }
  return found;
}

/// Folder of every target that the CMake files define.
std::map<std::string, std::string> folders_of_targets(const Files& files) {
  static const std::set<std::string> defining = {"add_library", "add_executable", "arcbid_test"};
  std::map<std::string, std::string> folders;
  for (const SourceFile& file : files)
    if (is_cmake(file.path))
      for (const CMakeCall& call : cmake_calls(file.text))
        if (defining.contains(call.name) && !call.arguments.empty())
          folders.emplace(call.arguments[0], file.path.substr(0, file.path.rfind('/') + 1));
  return folders;
}

/// Calls `visit(file, line, target, its folder, linked library, that one's folder or "")`.
template <class Visit>
void for_each_link(const Files& files, Visit visit) {
  const auto folders = folders_of_targets(files);
  for (const SourceFile& file : files) {
    if (!is_cmake(file.path)) continue;
    for (const CMakeCall& call : cmake_calls(file.text)) {
      if (call.name != "target_link_libraries" || call.arguments.empty()) continue;
      const std::string& target = call.arguments[0];
      const auto known = folders.find(target);
      const std::string folder =
          known != folders.end() ? known->second : file.path.substr(0, file.path.rfind('/') + 1);
      for (std::size_t i = 1; i < call.arguments.size(); ++i) {
        const auto linked = folders.find(call.arguments[i]);
        visit(file, call.line, target, folder, call.arguments[i],
              linked == folders.end() ? std::string() : linked->second);
      }
    }
  }
}

/// Includes and links of a folder's files that lead to our own code elsewhere, unless it is_free.
template <class IsFree>
Violations shared_code(const Files& files, const std::string& folder, const std::string& what,
                       IsFree is_free) {
  const auto is_shared = [&](const std::string& path) {
    return legal_edges.contains(layer_of(path)) && !path.starts_with(folder) && !is_free(path);
  };
  Violations found;
  for (const SourceFile& file : files)
    if (is_cpp(file.path) && file.path.starts_with(folder))
      for (const Include& include : includes(file.text))
        if (is_shared(include.name))
          found.push_back(
              fmt::format("{}:{}: includes {}; {}", file.path, include.line, include.name, what));
  for_each_link(files, [&](const SourceFile& file, int line, const std::string& target,
                           const std::string& target_folder, const std::string& library,
                           const std::string& library_folder) {
    if (target_folder.starts_with(folder) && is_shared(library_folder))
      found.push_back(
          fmt::format("{}:{}: {} links {}; {}", file.path, line, target, library, what));
  });
  return found;
}

}  // namespace

Violations include_layers(const Files& files) {
  Violations found;
  for (const SourceFile& file : files) {
    if (!is_cpp(file.path)) continue;
    const std::string from = layer_of(file.path);
    if (!legal_edges.contains(from) && !free_folders.contains(from))
      found.push_back(fmt::format("{}: {} is no known layer; add it to tests/rules/rules.cpp",
                                  file.path, from.empty() ? "the root" : from));
    for (const Include& include : includes(file.text)) {
      const std::string to = layer_of(include.name);
      const std::string place =
          fmt::format("{}:{}: includes {}; ", file.path, include.line, include.name);
      if (include.name.find("../") != std::string::npos)
        found.push_back(place + "legal: the path from the repository's root");
      else if ((legal_edges.contains(to) || free_folders.contains(to)) && !may_depend(from, to))
        found.push_back(place + forbidden_edge(from, to));
      else if (is_deciding(file.path) && include.name.starts_with("core/io/"))
        found.push_back(place + "what decides must not depend on core/io");
    }
  }
  return found;
}

Violations link_layers(const Files& files) {
  Violations found;
  for_each_link(files, [&](const SourceFile& file, int line, const std::string& target,
                           const std::string& folder, const std::string& library,
                           const std::string& library_folder) {
    const std::string place = fmt::format("{}:{}: {} links {}; ", file.path, line, target, library);
    const std::string from = layer_of(folder), to = layer_of(library_folder);
    if (!to.empty() && !from.empty() && !may_depend(from, to))
      found.push_back(place + forbidden_edge(from, to));
    if (is_deciding(folder) && library_folder.starts_with("core/io/"))
      found.push_back(place + "what decides must not depend on core/io");
    const char* fast_dds = may_lay_out_cdr(folder) ? "^fast(rtps|dds)$" : "^fast(rtps|cdr|dds)$";
    if ((from == "core" || from == "sim") && matches(library, fast_dds))
      found.push_back(place + "Fast DDS stays in idl and the processes");
    const char* outside = may_share_out_arithmetic(folder) ? "^(spdlog|SQLite|sqlite)"
                                                           : "^(spdlog|SQLite|sqlite|Threads::)";
    if (is_deciding(folder) && matches(library, outside))
      found.push_back(place + "core is arithmetic");
  });
  return found;
}

Violations core_is_arithmetic(const Files& files) {
  Violations found = includes_matching(
      files,
      "^(mutex|shared_mutex|condition_variable|future|stop_token|semaphore|fstream|iostream|"
      "filesystem|random|ctime|time\\.h|sys/.*|unistd\\.h|spdlog/.*|fast(dds|rtps|cdr)/"
      ".*|sqlite3.*)$",
      "core is arithmetic: time, randomness, files and messages come in as data", is_deciding);
  append(found, includes_matching(files, "^thread$", "legal only in .cpp files of core/airspace",
                                  [](const std::string& path) {
                                    return is_deciding(path) &&
                                           (!may_share_out_arithmetic(path) || is_header(path));
                                  }));
  const auto core_or_sim = [](const std::string& path) {
    return layer_of(path) == "core" || layer_of(path) == "sim";
  };
  append(found, includes_matching(files, "^fast(dds|rtps)/",
                                  "Fast DDS stays in idl and the processes", core_or_sim));
  append(found, includes_matching(
                    files, "^fastcdr/", "legal only in .cpp files of sim/mcap and core/io/record",
                    [&](const std::string& path) {
                      return core_or_sim(path) && (!may_lay_out_cdr(path) || is_header(path));
                    }));
  static const std::regex clocks(
      "\\b(steady_clock|system_clock|high_resolution_clock|clock_gettime|gettimeofday)\\b");
  for (const SourceFile& file : files)
    if (is_cpp(file.path) && is_deciding(file.path))
      append(found, lines_with(file, without_comments(file.text), clocks,
                               "reads a clock; core gets the time as an event's field"));
  return found;
}

Violations no_library_dependent_randomness(const Files& files) {
  static const std::regex pattern(
      "\\bstd::((ranges::)?shuffle|sample|\\w+_distribution|random_device|s?rand)\\b");
  Violations found;
  for (const SourceFile& file : files)
    if (is_cpp(file.path))
      append(found, lines_with(file, without_comments(file.text), pattern,
                               "differs between standard libraries or runs; legal: a seeded "
                               "generator with Boost.Random's distributions"));
  return found;
}

Violations geometry_libraries_stay_in_core(const Files& files) {
  return includes_matching(files, "^(pcl|CGAL)/", "legal only in .cpp files under core",
                           [](const std::string& path) {
                             return !free_folders.contains(layer_of(path)) &&
                                    (layer_of(path) != "core" || is_header(path));
                           });
}

Violations checker_is_independent(const Files& files) {
  return shared_code(files, "sim/checker/", "the checker shares nothing with what it checks",
                     [](const std::string&) { return false; });
}

Violations certificate_is_independent(const Files& files) {
  // The structure and the sensor as plain data, errors, and the checker's reader of routes.
  static const std::set<std::string> plain = {"core/arcs/arc.hpp", "core/base/error.hpp",
                                              "core/structure/sensor.hpp",
                                              "core/structure/structure.hpp"};
  return shared_code(files, "sim/certificate/", "the certificate shares no code with what plans",
                     [](const std::string& path) {
                       return path.starts_with("sim/checker/") || plain.contains(path);
                     });
}

Violations license_line(const Files& files) {
  const std::string line = "SPDX-License-Identifier: GPL-3.0-or-later";
  Violations found;
  for (const SourceFile& file : files) {
    const bool is_source = is_cpp(file.path) || is_cmake(file.path) ||
                           file.text.starts_with("#!") ||
                           matches(file.path, "\\.(idl|ya?ml|sh|py|ts|js|css|pml)$");
    // In the first lines: a script's first one is for the shell.
    if (is_source && file.text.substr(0, 300).find(line) == std::string::npos)
      found.push_back(fmt::format("{}:1: has no line \"{}\"", file.path, line));
  }
  return found;
}

Violations no_registry_hosts(const Files& files) {
  static const std::regex hosts(
      "(deb|security|snapshot)\\.debian[.]org|[a-z0-9.-]*\\.debian[.]org/debian|"
      "registry\\.(npmjs[.]org|yarnpkg[.]com)");
  Violations found;
  for (const SourceFile& file : files)
    append(found, lines_with(file, file.text, hosts, "is a package registry's host; remove it"));
  return found;
}

Violations marks_name_an_issue(const Files& files) {
  static const std::regex mark(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X|HA"
      "CK)\\b(?!.*#[0-9])");
  Violations found;
  for (const SourceFile& file : files)
    append(found, lines_with(file, file.text, mark, "without an issue's number (#N)"));
  return found;
}

}  // namespace arcbid::rules
