// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "core/io/config.hpp"
#include "core/io/config/keys.hpp"

namespace arcbid {
namespace {

std::string row(const std::string& key, const std::string& legal, const std::string& default_value,
                const std::string& meaning) {
  return fmt::format("| `{}` | {} | {} | {} |\n", key, legal, default_value, meaning);
}

}  // namespace

std::string to_yaml(const Config& config) {
  std::string text, open;  // open: the section that the last line stands in
  for (const yaml::Key<Config>& key : yaml::config_keys()) {
    const std::string value = key.print(config);
    if (value.empty()) continue;
    std::size_t indent = 0, start = 0;
    for (std::size_t dot; (dot = key.name.find('.', start)) != std::string::npos; start = dot + 1) {
      const std::string section = key.name.substr(0, dot + 1);
      if (!open.starts_with(section))
        text += fmt::format("{:{}}{}:\n", "", indent, key.name.substr(start, dot - start));
      indent += 2;
    }
    open = key.name.substr(0, start);
    text += fmt::format("{:{}}{}:{}{}\n", "", indent, key.name.substr(start),
                        value.starts_with('\n') ? "" : " ", value);
  }
  return text;
}

std::string config_reference() {
  std::string table = "| key | legal | default | meaning |\n|---|---|---|---|\n";
  for (const yaml::Key<Config>& key : yaml::config_keys()) {
    const std::string value = key.print(Config{});
    table += row(key.name, key.legal, value.empty() ? "absent" : "`" + value + "`", key.meaning);
    if (key.name != "fleet.uavs") continue;
    for (const yaml::Key<Uav>& uav : yaml::uav_keys())
      table += row("fleet.uavs[]." + uav.name, uav.legal,
                   uav.required ? "required" : "`fleet." + uav.name + "`", uav.meaning);
  }
  return table;
}

}  // namespace arcbid
