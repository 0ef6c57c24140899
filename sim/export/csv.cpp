// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/csv.hpp"

#include "core/base/error.hpp"

namespace arcbid {

CsvFile::CsvFile(std::filesystem::path path, std::string_view header)
    : path_(std::move(path)), file_(path_, std::ios::binary | std::ios::trunc) {
  line_ = header;
  end_line();
}

void CsvFile::text(std::string_view text) {
  if (!is_first_) line_ += ',';
  is_first_ = false;
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    line_ += text;
    return;
  }
  line_ += '"';
  for (const char c : text) {
    if (c == '"') line_ += '"';
    line_ += c;
  }
  line_ += '"';
}

void CsvFile::end_line() {
  line_ += "\r\n";
  file_.write(line_.data(), static_cast<std::streamsize>(line_.size()));
  is_first_ = true;
}

void CsvFile::close() {
  file_.close();
  if (!file_) throw RunError(fmt::format("{}: cannot be written", path_.string()));
}

}  // namespace arcbid
