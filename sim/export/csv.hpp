// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcbid {

/// A table in a file, as RFC 4180 has it: a header line, lines that end with CR LF, fields in
/// quotes where they need it. Numbers have a point and read back to the same bits. Throws RunError
/// when the file cannot be written.
class CsvFile {
 public:
  /// `header`: the columns' names, commas between them.
  CsvFile(std::filesystem::path path, std::string_view header);

  template <class... Fields>
  void row(const Fields&... fields) {
    line_.clear();
    (field(fields), ...);
    end_line();
  }
  /// The same for a row whose length is not known before.
  void fields(const std::vector<std::string>& texts) {
    line_.clear();
    for (const std::string& one : texts) text(one);
    end_line();
  }
  void close();

 private:
  template <class T>
  void field(const T& value) {
    text(fmt::format("{}", value));
  }
  template <class T>
  void field(const std::optional<T>& value) {
    text(value ? fmt::format("{}", *value) : "");
  }
  void text(std::string_view text);
  void end_line();

  std::filesystem::path path_;
  std::ofstream file_;
  std::string line_;
  bool is_first_ = true;
};

}  // namespace arcbid
