// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>

namespace arcbid::yaml {

/// The text of a small file; `what` names its kind in messages ("a fault file"). Throws InputError.
std::string read_text(const std::filesystem::path& file, const std::string& what);

/// The one YAML document in `text`, not empty. Throws InputError: what is no YAML, and what
/// yaml-cpp takes but a person did not mean (tabs, and a second document, which it skips).
YAML::Node parse_document(const std::string& text, const std::string& file,
                          const std::string& what);

}  // namespace arcbid::yaml
