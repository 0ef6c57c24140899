// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace arcbid::checker {

/// A file that cannot be taken as evidence. The message names the field, the value, and what is
/// legal.
class DamagedFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value of a JSON document together with its place in it, for messages.
class JsonField {
 public:
  JsonField(const nlohmann::json& value, std::string place)
      : value_(&value), place_(std::move(place)) {}

  JsonField at(const char* key) const;
  std::optional<JsonField> find(const char* key) const;  ///< none: older runs do not say it
  std::vector<JsonField> elements() const;
  bool is_null() const { return value_->is_null(); }

  double number() const;  ///< finite
  std::uint32_t id() const;
  std::string text() const;
  std::optional<double> number_or_null() const;
  std::optional<std::uint32_t> id_or_null() const;

  [[noreturn]] void refuse(const char* legal) const;

 private:
  const nlohmann::json* value_;
  std::string place_;
};

/// Parses a whole file. Throws DamagedFile when it is missing, not a regular file, or not JSON.
nlohmann::json parse_file(const std::filesystem::path& file);

}  // namespace arcbid::checker
