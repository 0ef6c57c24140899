// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/rules/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace arcbid::rules {
namespace {

namespace fs = std::filesystem;

bool is_left_out(const fs::directory_entry& folder) {
  static const std::set<std::string> names = {".git", "build", "runs", "node_modules"};
  return names.contains(folder.path().filename()) || fs::exists(folder.path() / "CMakeCache.txt");
}

bool ends_with_any(const std::string& path, const std::vector<std::string>& endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](const std::string& ending) { return path.ends_with(ending); });
}

int line_at(const std::string& text, std::size_t position) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + position, '\n'));
}

}  // namespace

std::vector<SourceFile> read_tree(const fs::path& root) {
  std::vector<SourceFile> files;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::end(it); ++it) {
    if (it->is_directory() && is_left_out(*it)) it.disable_recursion_pending();
    if (!it->is_regular_file()) continue;
    std::ifstream in(it->path(), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (text.str().find('\0') == std::string::npos)
      files.push_back({it->path().lexically_relative(root).generic_string(), text.str()});
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

bool is_header(const std::string& path) {
  return ends_with_any(path, {".hpp", ".h", ".hh"});
}
bool is_cpp(const std::string& path) {
  return is_header(path) || ends_with_any(path, {".cpp", ".cc", ".cxx"});
}
bool is_cmake(const std::string& path) {
  return path == "CMakeLists.txt" || ends_with_any(path, {"/CMakeLists.txt", ".cmake"});
}

std::string without_comments(const std::string& text) {
  std::string out = text;
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (; from < std::min(to, out.size()); ++from)
      if (out[from] != '\n') out[from] = ' ';
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      while (++i < text.size() && text[i] != '"' && text[i] != '\n')
        if (text[i] == '\\') ++i;
    } else if (text.compare(i, 2, "//") == 0) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      blank(i, end);
      i = end;
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t end = std::min(text.find("*/", i + 2), text.size());
      blank(i, end + 2);
      i = end + 1;
    }
  }
  return out;
}

std::vector<Include> includes(const std::string& text) {
  std::vector<Include> found;
  std::istringstream lines(without_comments(text));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line[at] != '#') continue;
    at = line.find_first_not_of(" \t", at + 1);
    if (at == std::string::npos || line.compare(at, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("<\"", at);
    if (open == std::string::npos) continue;
    const std::size_t close = line.find_first_of(">\"", open + 1);
    if (close != std::string::npos)
      found.push_back({line.substr(open + 1, close - open - 1), number});
  }
  return found;
}

std::vector<CMakeCall> cmake_calls(const std::string& text) {
  std::string code = text;  // without comments
  for (std::size_t i = code.find('#'); i != std::string::npos; i = code.find('#', i))
    while (i < code.size() && code[i] != '\n') code[i++] = ' ';
  std::vector<CMakeCall> calls;
  std::size_t at = 0;
  for (std::size_t open; (open = code.find('(', at)) != std::string::npos;) {
    const std::size_t close = std::min(code.find(')', open), code.size());
    std::istringstream before(code.substr(at, open - at)),
        inside(code.substr(open + 1, close - open - 1));
    CMakeCall call;
    call.line = line_at(code, open);
    for (std::string word; before >> word;) call.name = word;
    for (std::string word; inside >> word;) call.arguments.push_back(word);
    calls.push_back(call);
    at = std::min(close + 1, code.size());
  }
  return calls;
}

}  // namespace arcbid::rules
