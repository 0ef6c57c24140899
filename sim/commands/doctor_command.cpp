// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/doctor_command.hpp"

#include <fmt/format.h>

#include "sim/replay/salvage.hpp"

namespace arcbid {

DoctorCommand::DoctorCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "doctor", "say what is intact of a run's logs and what is lost; 0: all is whole")) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  command_->add_flag("--json", json_, "as JSON");
  command_
      ->add_option("--salvage", salvage_,
                   "write a run directory with everything that is intact, for other commands")
      ->type_name("DIR");
}

Exit DoctorCommand::run() const {
  const RunReport report = examine(run_);
  if (json_)
    fmt::print("{}\n", to_json(report).dump(1));
  else
    fmt::print("{}", describe(report));
  if (!salvage_.empty()) {
    salvage(run_, report, salvage_);
    if (!json_) fmt::print("what is intact is in {}\n", salvage_);
  }
  return report.whole() ? Exit::done : Exit::check_failed;
}

}  // namespace arcbid
