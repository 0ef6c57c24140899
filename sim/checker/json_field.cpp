// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/checker/json_field.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace arcbid::checker {

namespace {

std::string shortened(const nlohmann::json& value) {
  if (value.is_structured()) return fmt::format("an {}", value.type_name());
  // Bytes that are not UTF-8 must not throw on the way into a message.
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > 40) text = text.substr(0, 37) + "...";
  return text;
}

}  // namespace

JsonField JsonField::at(const char* key) const {
  if (!value_->is_object()) refuse("an object");
  const auto found = value_->find(key);
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (found == value_->end()) throw DamagedFile(fmt::format("{} is missing", place));
  return {*found, place};
}

std::optional<JsonField> JsonField::find(const char* key) const {
  if (!value_->is_object() || !value_->contains(key)) return std::nullopt;
  return at(key);
}

std::vector<JsonField> JsonField::elements() const {
  if (!value_->is_array()) refuse("an array");
  std::vector<JsonField> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.emplace_back((*value_)[i], fmt::format("{}[{}]", place_, i));
  return result;
}

double JsonField::number() const {
  if (!value_->is_number()) refuse("a finite number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) refuse("a finite number");
  return number;
}

std::uint32_t JsonField::id() const {
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max();
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() > kLargest)
    refuse("an integer from 0 to 4294967295");
  return value_->get<std::uint32_t>();
}

std::string JsonField::text() const {
  if (!value_->is_string()) refuse("a string");
  return value_->get<std::string>();
}

std::optional<double> JsonField::number_or_null() const {
  if (value_->is_null()) return std::nullopt;
  return number();
}

std::optional<std::uint32_t> JsonField::id_or_null() const {
  if (value_->is_null()) return std::nullopt;
  return id();
}

void JsonField::refuse(const char* legal) const {
  throw DamagedFile(fmt::format("{} is {}, must be {}", place_.empty() ? "the document" : place_,
                                shortened(*value_), legal));
}

nlohmann::json parse_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw DamagedFile("the file is missing");
  if (!std::filesystem::is_regular_file(file, ignored)) throw DamagedFile("not a regular file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw DamagedFile("the file cannot be opened");
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& e) {
    throw DamagedFile(fmt::format("not JSON: {}", e.what()));
  }
}

}  // namespace arcbid::checker
