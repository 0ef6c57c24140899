// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.hpp"
#include "tests/replay/damaged_run.hpp"
#include "tests/replay/older_run.hpp"

namespace arcbid::testing {

/// Why an act was refused; empty: it was not.
inline std::string problem_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A run of three that another arcbid recorded.
class OlderRun : public DamagedRun {
 protected:
  void age(const std::function<std::string(const std::string&, std::string)>& change = otherwise) {
    record();
    was = folder / "was";
    std::filesystem::copy(run, was, std::filesystem::copy_options::recursive);
    make_older(run, change);
    records = readable(log, 100'000);
  }
  std::filesystem::path was;  ///< the same run as this arcbid recorded it
};

}  // namespace arcbid::testing
