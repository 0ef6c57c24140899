// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/rules/source_tree.hpp"

namespace arcbid::rules {

using Files = std::vector<SourceFile>;

/// What breaks a rule: one line each, "path:line: what and what would be legal". A rule that holds
/// gives none.
using Violations = std::vector<std::string>;

/// agent, coordinator -> idl -> core <- sim: for #include lines ...
Violations include_layers(const Files& files);
/// ... and for target_link_libraries.
Violations link_layers(const Files& files);

/// What decides gets time, randomness, files and messages as data: nothing of the world is
/// included.
Violations core_is_arithmetic(const Files& files);

/// The same inputs must give the same outputs with every standard library.
Violations no_library_dependent_randomness(const Files& files);

/// PCL and CGAL are seen by .cpp files of core only.
Violations geometry_libraries_stay_in_core(const Files& files);

/// The checker shares nothing with what it checks.
Violations checker_is_independent(const Files& files);

/// The certificate shares no code with what plans: of core it sees plain data only.
Violations certificate_is_independent(const Files& files);

Violations license_line(const Files& files);
Violations no_registry_hosts(const Files& files);
/// Whatever is left to do has an issue's number.
Violations marks_name_an_issue(const Files& files);

}  // namespace arcbid::rules
