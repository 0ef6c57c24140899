// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/record/other_build.hpp"

#include <stdexcept>

namespace arcbid::testing {

std::string with(std::string schema, const std::string& part, const std::string& line,
                 const std::string& by) {
  const auto from = part.empty() ? 0 : schema.find("MSG: arcbid_msgs/" + part + "\n");
  if (from == std::string::npos) throw std::runtime_error("no part " + part);
  const std::string found = "\n" + line + "\n";
  const bool is_first = from == 0 && schema.starts_with(line + "\n");
  const auto at = is_first ? 0 : schema.find(found, from) + 1;
  if (!is_first && at == 0) throw std::runtime_error("no line " + line);
  return schema.replace(at, line.size() + 1, by.empty() ? "" : by + "\n");
}

}  // namespace arcbid::testing
