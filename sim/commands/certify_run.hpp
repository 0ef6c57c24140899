// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/io/config.hpp"
#include "sim/certificate/certificate.hpp"

namespace arcbid {

struct CertifyOptions {
  std::optional<std::filesystem::path> structure;  ///< instead of the config's, with its unit, axis
  double spacing_m = 0.3;
  bool tells_progress = false;  ///< a line for each stage on standard error
};

/// Certifies a run directory by what stands in it and by the structure that its config names, as it
/// is now, and writes certificate.json and certificate_samples.bin. Throws InputError: one line
/// that names what is missing or damaged.
certificate::Certificate certify_run(const std::filesystem::path& run,
                                     const CertifyOptions& options);

/// The config of a run directory, with another structure file if one is given.
Config config_of_run(const std::filesystem::path& run,
                     const std::optional<std::filesystem::path>& structure);

}  // namespace arcbid
