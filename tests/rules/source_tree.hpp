// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace arcbid::rules {

/// A text file of the repository.
struct SourceFile {
  std::string path;  ///< from the repository's root, with forward slashes
  std::string text;
};

/// All text files under `root`, by path; without builds, run folders, and what git keeps.
std::vector<SourceFile> read_tree(const std::filesystem::path& root);

bool is_cpp(const std::string& path);
bool is_header(const std::string& path);
bool is_cmake(const std::string& path);

/// An #include line: what stands between the quotes or brackets.
struct Include {
  std::string name;
  int line = 0;
};
/// Includes of C++ text; commented ones do not count.
std::vector<Include> includes(const std::string& text);

/// A command of a CMake file: name(arguments ...).
struct CMakeCall {
  std::string name;
  std::vector<std::string> arguments;
  int line = 0;
};
std::vector<CMakeCall> cmake_calls(const std::string& text);

/// C++ text with its comments blanked out; lines stay where they are.
std::string without_comments(const std::string& text);

}  // namespace arcbid::rules
