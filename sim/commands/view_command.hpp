// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/error.hpp"
#include "sim/view/server.hpp"

namespace arcbid {

/// `arcbid view RUN` serves the viewer; `arcbid report RUN` writes it as one file.
class ViewCommand {
 public:
  explicit ViewCommand(CLI::App& app);
  bool parsed() const { return view_->parsed() || report_->parsed(); }
  /// `programs`: where arcbid itself is.
  Exit run(const std::filesystem::path& programs) const;

 private:
  Exit serve(const std::filesystem::path& programs) const;
  void wait_beside(const ViewServer& server) const;

  CLI::App* view_;
  CLI::App* report_;
  std::string run_, out_, data_;
  std::uint16_t port_ = 0;
};

/// Writes a run's report and says where. Throws InputError.
void write_report(const std::filesystem::path& run, const std::filesystem::path& programs,
                  const std::filesystem::path& out);

}  // namespace arcbid
