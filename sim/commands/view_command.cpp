// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/view_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

#include "core/io/process/process.hpp"
#include "core/io/run/run_files.hpp"
#include "core/io/run/run_lock.hpp"
#include "sim/commands/tell.hpp"
#include "sim/view/page.hpp"
#include "sim/view/server.hpp"
#include "sim/view/view_data.hpp"

namespace arcbid {
namespace {

RunArchive opened(const std::filesystem::path& directory) {
  RunArchive run = open_run(directory);
  tell_unverifiable(run);
  return run;
}

/// The page that `arcbid reproduce` left, in a directory that holds no run.
std::optional<std::string> page_of_reproduction(const std::filesystem::path& directory) {
  std::ifstream in(directory / "index.html", std::ios::binary);
  if (!in || std::filesystem::exists(directory / "logs")) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

ViewCommand::ViewCommand(CLI::App& app)
    : view_(app.add_subcommand(
          "view", "see a run in a browser, also while it goes on; or what `reproduce` left")),
      report_(app.add_subcommand(
          "report", "write the viewer and the run as one HTML file that opens from disk")) {
  view_->add_option("run", run_, "run directory, or the one of `arcbid reproduce`")
      ->required()
      ->check(CLI::ExistingDirectory);
  view_->add_option("--port", port_, "on 127.0.0.1; 0: any that is free (default)");
  report_->add_option("run", run_, "run directory")->required()->check(CLI::ExistingDirectory);
  report_->add_option("--out", out_, "the file (default: RUN/report.html)");
  report_->add_option("--data", data_, "write what the page is given as JSON to this file instead");
}

Exit ViewCommand::run(const std::filesystem::path& programs) const {
  if (view_->parsed()) return serve(programs);
  const std::filesystem::path run = run_;
  if (!data_.empty()) {
    write_whole(data_, view_data(opened(run)).dump());
    return Exit::done;
  }
  write_report(run, programs, out_.empty() ? run / "report.html" : std::filesystem::path(out_));
  return Exit::done;
}

void ViewCommand::wait_beside(const ViewServer& server) const {
  fmt::print("{} is at {} until Ctrl-C\n", run_, server.address());
  std::fflush(stdout);
  while (!stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

Exit ViewCommand::serve(const std::filesystem::path& programs) const {
  if (auto page = page_of_reproduction(run_)) {
    wait_beside(ViewServer(std::move(*page), port_));
    return Exit::done;
  }
  // A run that nobody writes any more has to open; one that goes on may not have its logs yet.
  if (!goes_on(run_)) opened(run_);
  wait_beside(ViewServer(run_, programs, port_, [this] { return goes_on(run_); }));
  return Exit::done;
}

void write_report(const std::filesystem::path& run, const std::filesystem::path& programs,
                  const std::filesystem::path& out) {
  std::string page = viewer_page(programs);
  write_whole(out, report_page(std::move(page), view_data(opened(run)).dump()));
  fmt::print("{:<20}{}\n", "report", out.string());
}

}  // namespace arcbid
