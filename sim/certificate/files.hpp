// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/certificate/certificate.hpp"

namespace arcbid::certificate {

/// RUN/certificate.json and RUN/certificate_samples.bin (docs/RUN_DIRECTORY.md).
nlohmann::json to_json(const Certificate& certificate);
std::string samples_file(const Certificate& certificate);

/// The certificate for people: a few lines.
std::string table(const Certificate& certificate);

/// The arcs and routes of a run directory. Throws InputError when a file is missing or damaged.
Flown read_flown(const std::filesystem::path& run);

}  // namespace arcbid::certificate
