// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/json_place.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/base/error.hpp"

namespace arcbid {

using nlohmann::json;

namespace {

constexpr std::size_t most_shown = 40;

/// Bytes that are no UTF-8 must not throw on their way into a message.
std::string shown(const json& value) {
  if (value.is_structured()) return fmt::format("an {}", value.type_name());
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() <= most_shown ? text : text.substr(0, most_shown) + "...";
}

}  // namespace

JsonPlace JsonPlace::inside(const json& value, const std::string& path) const {
  JsonPlace place(value, file_);
  place.path_ = path;
  return place;
}

void JsonPlace::refuse(const std::string& legal) const {
  throw InputError(fmt::format("{}: {}: {} is not {}", file_, path_.empty() ? "all of it" : path_,
                               shown(*value_), legal));
}

JsonPlace JsonPlace::at(const std::string& key) const {
  if (!value_->is_object()) refuse("an object");
  const std::string path = path_.empty() ? key : path_ + "." + key;
  const auto found = value_->find(key);
  if (found == value_->end()) throw InputError(fmt::format("{}: {}: missing", file_, path));
  return inside(*found, path);
}

std::vector<JsonPlace> JsonPlace::elements() const {
  if (!value_->is_array()) refuse("a list");
  std::vector<JsonPlace> out;
  for (std::size_t i = 0; i < value_->size(); ++i)
    out.push_back(inside((*value_)[i], fmt::format("{}[{}]", path_, i)));
  return out;
}

double JsonPlace::number() const {
  if (!value_->is_number() || !std::isfinite(value_->get<double>())) refuse("a finite number");
  return value_->get<double>();
}

std::uint64_t JsonPlace::whole(std::uint64_t most) const {
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() > most)
    refuse(fmt::format("an integer in [0, {}]", most));
  return value_->get<std::uint64_t>();
}

bool JsonPlace::truth() const {
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

std::string JsonPlace::text() const {
  if (!value_->is_string()) refuse("text");
  return value_->get<std::string>();
}

std::uint64_t JsonPlace::hex() const {
  const std::string digits = text();
  std::uint64_t value = 0;
  const auto [stop, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || stop != digits.data() + digits.size())
    refuse("a hexadecimal number of 64 bits");
  return value;
}

}  // namespace arcbid
