// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace arcbid {

/// A value of a JSON document and where it stands: "result.json: faults[2].agent". What is not
/// there, or is something else, throws InputError with that place.
class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& value, std::string file)
      : value_(&value), file_(std::move(file)) {}

  JsonPlace at(const std::string& key) const;
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  std::vector<JsonPlace> elements() const;
  bool is_null() const { return value_->is_null(); }

  double number() const;                          ///< finite
  std::uint64_t whole(std::uint64_t most) const;  ///< an integer in [0, most]
  bool truth() const;
  std::string text() const;
  std::uint64_t hex() const;  ///< a 64-bit number as hexadecimal text

  [[noreturn]] void refuse(const std::string& legal) const;

 private:
  JsonPlace inside(const nlohmann::json& value, const std::string& path) const;

  const nlohmann::json* value_;
  std::string file_, path_;
};

}  // namespace arcbid
