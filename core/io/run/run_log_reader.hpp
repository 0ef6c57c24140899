// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/ids.hpp"

namespace arcbid {

/// Reads the event log of one process (RunLog), also one whose process was killed. All of it throws
/// InputError: one line with the file's name.
class RunLogReader {
 public:
  explicit RunLogReader(const std::filesystem::path& file);
  ~RunLogReader();

  nlohmann::json meta(std::string_view key) const;

  struct Event {
    TimeNs t_ns = 0;  ///< since launch
    std::string kind;
    nlohmann::json body;
  };
  /// The first event of a kind.
  std::optional<Event> first(std::string_view kind) const;
  std::optional<Event> last() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace arcbid
