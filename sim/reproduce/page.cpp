// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "sim/reproduce/report.hpp"
#include "sim/view/base64.hpp"

namespace arcbid::reproduce {
namespace {

/// Text as HTML; what stands between `backticks` as code.
std::string escaped(std::string_view text) {
  std::string out;
  bool is_code = false;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '`':
        out += is_code ? "</code>" : "<code>";
        is_code = !is_code;
        break;
      default:
        out += c;
    }
  return out;
}

std::string table_element(const Table& table) {
  std::string out = "<div class=\"wide\"><table><thead><tr>";
  for (const Column& column : table.columns)
    out += fmt::format("<th{}>{}</th>", column.title.starts_with("paper") ? " class=\"paper\"" : "",
                       escaped(column.title));
  out += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      out += fmt::format("<td class=\"{}{}\">{}</td>",
                         std::holds_alternative<std::string>(row[c]) ? "text" : "number",
                         table.columns[c].title.starts_with("paper") ? " paper" : "",
                         escaped(shown(row[c], table.columns[c])));
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

/// As an image, so that the names within one picture do not meet those of another.
std::string picture_element(const Picture& picture, const std::filesystem::path& folder) {
  std::ifstream in(folder / (picture.name + ".svg"), std::ios::binary);
  if (!in) return "";
  const std::string svg(std::istreambuf_iterator<char>(in), {});
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/svg+xml;base64,{1}\"><figcaption>{0}"
      "</figcaption></figure>\n",
      escaped(picture.caption), base64(svg));
}

constexpr std::string_view kHead =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
    "style-src 'unsafe-inline'\">\n<title>The paper's experiments, again</title>\n<style>\n"
    "body{font:16px/1.5 sans-serif;margin:2em auto;max-width:72em;padding:0 1em;color:#222;"
    "background:#fff}\n.wide{overflow-x:auto}\ntable{border-collapse:collapse;font-size:14px}\n"
    "th,td{border-bottom:1px solid #ddd;padding:2px 8px}\nth{text-align:left;vertical-align:"
    "bottom}\n.number{text-align:right;font-variant-numeric:tabular-nums}\n"
    ".paper{background:#f3f0e6}\nfigure{margin:1em 0}\nimg{max-width:100%}\n"
    "figcaption{color:#555}\n</style></head><body>\n<h1>The paper's experiments, again</h1>\n";

}  // namespace

std::string html(const std::vector<Finding>& findings, const std::string& command,
                 const std::filesystem::path& folder) {
  std::string out(kHead);
  out += fmt::format(
      "<p><code>{}</code></p>\n<p>Shaded columns are the numbers of Liu, Zhang and Wang (2021); "
      "all others are ours. Seconds are CPU seconds.</p>\n",
      escaped(command));
  for (const Finding& finding : findings) {
    out +=
        fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n{}", escaped(finding.name),
                    escaped(finding.title), escaped(finding.setting), table_element(finding.table));
    for (const Picture& picture : finding.pictures) out += picture_element(picture, folder);
    out += "<h3>Where it differs, and why</h3>\n<ul>\n";
    for (const std::string& difference : finding.differences)
      out += fmt::format("<li>{}</li>\n", escaped(difference));
    out += "</ul>\n</section>\n";
  }
  return out + "</body></html>\n";
}

}  // namespace arcbid::reproduce
