// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/certify_run.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/error.hpp"
#include "core/io/build/build.hpp"
#include "core/io/process/process.hpp"
#include "core/io/run/run_files.hpp"
#include "core/io/structure_reader.hpp"
#include "sim/certificate/files.hpp"

namespace arcbid {
namespace {

Structure structure_of(const StructureConfig& config) {
  if (!config.file) return generate(config.parametric);
  return read_structure(*config.file, {.unit = config.unit, .up = config.up}).structure;
}

certificate::Settings settings_of(const CoverageSettings& coverage, double spacing_m) {
  certificate::Settings settings;
  settings.sensor = coverage.sensor;
  settings.safety_m = coverage.safety_m;
  settings.ground_clearance_m = coverage.ground_clearance_m;
  settings.ground_m = coverage.ground_m;
  settings.spacing_m = spacing_m;
  settings.mission_seed = coverage.seed;
  return settings;
}

}  // namespace

Config config_of_run(const std::filesystem::path& run,
                     const std::optional<std::filesystem::path>& structure) {
  const std::filesystem::path file = run / "config.yaml";
  if (!std::filesystem::exists(file))
    throw InputError(
        fmt::format("{}: missing: it says what was to be seen, and how", file.string()));
  if (!structure) return load_config(file);
  // Put in before it is checked: the config's own file may be gone.
  YAML::Node node;
  try {
    node = YAML::LoadFile(file.string());
    node["structure"]["file"] = std::filesystem::absolute(*structure).string();
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return parse_config(YAML::Dump(node), file);
}

certificate::Certificate certify_run(const std::filesystem::path& run,
                                     const CertifyOptions& options) {
  const TimeNs start_ns = monotonic_ns();
  const auto seconds = [start_ns] { return static_cast<double>(monotonic_ns() - start_ns) * 1e-9; };
  const Config config = config_of_run(run, options.structure);
  const certificate::Flown flown = certificate::read_flown(run);
  const auto tell = [&](std::string_view stage) {
    if (options.tells_progress)
      fmt::print(stderr, "{:7.2f} s  certificate: {}\n", seconds(), stage);
  };
  tell("the surface, and where one can fly");
  const certificate::Certificate result = certificate::certify(
      structure_of(config.structure), flown, settings_of(config.coverage, options.spacing_m), tell);
  nlohmann::json json = certificate::to_json(result);
  json["seconds"] = seconds();
  json["build"] = fmt::format("{} {}", build_version(), build_commit());
  write_whole(run / "certificate_samples.bin", certificate::samples_file(result));
  write_whole(run / "certificate.json", json.dump(2) + "\n");
  return result;
}

}  // namespace arcbid
