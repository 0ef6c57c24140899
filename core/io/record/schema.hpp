// SPDX-License-Identifier: GPL-3.0-or-later
// A record's fields in ROS 2's message language, as CdrWriter writes them.
#pragma once

#include <map>
#include <string>

#include "core/io/record/cdr.hpp"

namespace arcbid {

class SchemaWriter {
 public:
  template <class T>
  void operator()(std::string_view field, const T& value) {
    line(type(value), field);
  }
  template <std::size_t n, class... Ts>
  void choice(const std::array<std::string_view, n>& names, const std::variant<Ts...>&) {
    std::size_t at = 0;
    (line(type(Ts{}) + "[<=1]", names[at++]), ...);
  }

  /// The record's own fields, then every type that these are made of.
  template <class T>
  static std::string of() {
    std::map<std::string_view, std::string> parts;
    SchemaWriter writer(parts);
    T record{};
    fields(writer, record);
    std::string text = writer.text_;
    for (const auto& [name, fields_text] : parts)
      text += fmt::format("{}\nMSG: arcbid_msgs/{}\n{}", std::string(80, '='), name, fields_text);
    return text;
  }

  /// A value's type by itself.
  template <class T>
  static std::string type_of() {
    std::map<std::string_view, std::string> parts;
    return SchemaWriter(parts).type(T{});
  }

 private:
  explicit SchemaWriter(std::map<std::string_view, std::string>& parts) : parts_(parts) {}

  void line(const std::string& type, std::string_view field) {
    text_ += fmt::format("{} {}\n", type, field);
  }
  template <class T>
  std::string type(const T&) {
    if constexpr (std::same_as<T, bool>) return "bool";
    if constexpr (std::is_enum_v<T>) return "uint8";
    if constexpr (std::same_as<T, double>) return "float64";
    if constexpr (std::integral<T> && !std::same_as<T, bool>)
      return fmt::format("{}int{}", std::is_signed_v<T> ? "" : "u", 8 * sizeof(T));
    if constexpr (IsId<T>) return "uint32";
    if constexpr (std::same_as<T, std::string>) return "string";
    if constexpr (std::same_as<T, Vec3>) return "float64[3]";
    if constexpr (!record_name<T>.empty()) return part<T>();
  }
  template <class T>
  std::string type(const std::vector<T>&) {
    return type(T{}) + "[]";
  }
  template <class T>
  std::string type(const std::optional<T>&) {
    if constexpr (IsId<T>) return "int64";
    return type(T{}) + "[<=1]";
  }
  template <class T>
  std::string part() {
    if (!parts_.contains(record_name<T>)) {
      parts_[record_name<T>];
      SchemaWriter writer(parts_);
      T record{};
      fields(writer, record);
      parts_[record_name<T>] = writer.text_;
    }
    return fmt::format("arcbid_msgs/{}", record_name<T>);
  }

  std::map<std::string_view, std::string>& parts_;
  std::string text_;
};

}  // namespace arcbid
