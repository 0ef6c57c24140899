// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "sim/reproduce/report.hpp"

namespace arcbid::reproduce {
namespace {

std::string table_text(const Table& table) {
  std::string head = "|", rule = "|", body;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    head += fmt::format(" {} |", table.columns[c].title);
    const bool is_text =
        !table.rows.empty() && std::holds_alternative<std::string>(table.rows.front()[c]);
    rule += is_text ? "---|" : "---:|";
  }
  for (const auto& row : table.rows) {
    body += "|";
    for (std::size_t c = 0; c < row.size(); ++c)
      body += fmt::format(" {} |", shown(row[c], table.columns[c]));
    body += "\n";
  }
  return head + "\n" + rule + "\n" + body;
}

}  // namespace

std::string shown(const Cell& cell, const Column& column) {
  if (const double* number = std::get_if<double>(&cell)) {
    const std::string text = fmt::format("{:.{}f}", *number, column.digits);
    // What is rounded to nothing has no sign.
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-'
               ? text.substr(1)
               : text;
  }
  const std::string* text = std::get_if<std::string>(&cell);
  return text ? *text : "";
}

std::string markdown(const std::vector<Finding>& findings, const std::string& command,
                     bool has_pictures) {
  std::string out = fmt::format(
      "# The paper's experiments, again\n\n`{}`\n\nColumns headed *paper* are the numbers of Liu, "
      "Zhang and Wang (2021); all others are ours. Seconds are CPU seconds.\n",
      command);
  for (const Finding& finding : findings) {
    out += fmt::format("\n## {}\n\n{}\n\n{}\n", finding.title, finding.setting,
                       table_text(finding.table));
    if (has_pictures)
      for (const Picture& picture : finding.pictures)
        out += fmt::format("![{}]({}.svg)\n\n", picture.caption, picture.name);
    out += "Where it differs, and why:\n\n";
    for (const std::string& difference : finding.differences)
      out += fmt::format("- {}\n", difference);
  }
  return out;
}

}  // namespace arcbid::reproduce
