// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/export_command.hpp"

#include <fmt/format.h>

#include "sim/commands/tell.hpp"
#include "sim/export/csv_export.hpp"
#include "sim/export/mcap_export.hpp"

namespace arcbid {
namespace {

using Path = std::filesystem::path;

void expect_free(const Path& file, const char* option) {
  if (std::filesystem::exists(file))
    throw InputError(fmt::format("{}: {}: exists; name another, or replace it with --force", option,
                                 file.string()));
}

void expect_folder(const Path& folder, const char* option) {
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw InputError(fmt::format("{}: {}: is no folder", option, folder.string()));
}

}  // namespace

ExportCommand::ExportCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "export", "write a run for other tools: Foxglove, PlotJuggler, ROS 2, spreadsheets")) {
  command_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  command_->add_option("--mcap", mcap_, "MCAP file of ROS 2 messages")->type_name("FILE");
  command_->add_option("--csv", csv_, "folder for tables; made where it is missing")
      ->type_name("DIR");
  command_->add_flag("--force", force_, "replace files that are there");
}

Exit ExportCommand::run() const {
  if (mcap_.empty() && csv_.empty())
    throw InputError("export: nothing to write; legal: --mcap FILE, --csv DIR, or both");
  if (!mcap_.empty()) expect_folder(Path(mcap_).parent_path(), "--mcap");
  if (!mcap_.empty() && !force_) expect_free(mcap_, "--mcap");
  if (!csv_.empty() && std::filesystem::exists(csv_)) expect_folder(csv_, "--csv");
  if (!csv_.empty() && !force_)
    for (const Path& file : csv_files(csv_)) expect_free(file, "--csv");
  const RunArchive run = open_run(run_);
  for (const std::string& problem : run.unreadable) fmt::print("left out: {}\n", problem);
  tell_unverifiable(run);
  if (!mcap_.empty()) {
    for (const std::string& missing : export_mcap(run, mcap_))
      fmt::print("left out: {}\n", missing);
    fmt::print("written: {}\n", mcap_);
  }
  if (!csv_.empty()) {
    export_csv(run, csv_);
    for (const Path& file : csv_files(csv_)) fmt::print("written: {}\n", file.string());
  }
  return Exit::done;
}

}  // namespace arcbid
