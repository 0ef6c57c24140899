// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/reproduce/experiment.hpp"

namespace arcbid::reproduce {

/// A cell as people are shown it: `column.digits` behind the point; empty: nothing.
std::string shown(const Cell& cell, const Column& column);

/// The paper's numbers beside ours, as a document. `command`: by which it can be had again;
/// `has_pictures`: whether NAME.svg of every picture is beside it.
std::string markdown(const std::vector<Finding>& findings, const std::string& command,
                     bool has_pictures);

/// The same as one HTML page that needs nothing else; pictures are read from `folder`, and those
/// that are not there left out.
std::string html(const std::vector<Finding>& findings, const std::string& command,
                 const std::filesystem::path& folder);

/// RFC 4180; numbers read back to the same bits. Throws RunError.
void write_csv(const Table& table, const std::filesystem::path& file);

/// What gnuplot draws a picture by, into NAME.svg where it is run; data and all.
std::string gnuplot_script(const Picture& picture);

/// Whether gnuplot is there. Else nothing is drawn; throws RunError where it draws nothing although
/// it is.
bool draw(const std::filesystem::path& folder, const std::string& script);

}  // namespace arcbid::reproduce
