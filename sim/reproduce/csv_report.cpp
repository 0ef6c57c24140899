// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "sim/export/csv.hpp"
#include "sim/reproduce/report.hpp"

namespace arcbid::reproduce {

void write_csv(const Table& table, const std::filesystem::path& file) {
  std::string header;
  for (const Column& column : table.columns) header += (header.empty() ? "" : ",") + column.name;
  CsvFile csv(file, header);
  for (const auto& row : table.rows) {
    std::vector<std::string> fields;
    for (const Cell& cell : row) {
      if (const double* number = std::get_if<double>(&cell))
        fields.push_back(fmt::format("{}", *number));
      else if (const std::string* text = std::get_if<std::string>(&cell))
        fields.push_back(*text);
      else
        fields.emplace_back();
    }
    csv.fields(fields);
  }
  csv.close();
}

}  // namespace arcbid::reproduce
