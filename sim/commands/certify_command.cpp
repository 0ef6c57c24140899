// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/certify_command.hpp"

#include <fmt/format.h>

#include "sim/certificate/files.hpp"
#include "sim/commands/certify_run.hpp"

namespace arcbid {

CertifyCommand::CertifyCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "certify",
          "measure what a run's routes see of the structure and how near they come, and write "
          "certificate.json")) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  command_
      ->add_option("--structure", structure_,
                   "the structure's file, when it is no longer where the config says")
      ->check(CLI::ExistingFile);
  command_->add_option("--spacing", spacing_m_, "metres between surface points (default: 0.3)")
      ->check(CLI::Range(0.02, 10.0));
}

Exit CertifyCommand::run() const {
  CertifyOptions options{.structure = {}, .spacing_m = spacing_m_, .tells_progress = true};
  if (!structure_.empty()) options.structure = structure_;
  const certificate::Certificate result = certify_run(run_, options);
  fmt::print("{}", certificate::table(result));
  return result.keeps_clear() ? Exit::done : Exit::check_failed;
}

}  // namespace arcbid
