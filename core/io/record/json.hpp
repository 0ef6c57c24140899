// SPDX-License-Identifier: GPL-3.0-or-later
// Records for people. What a double can't hold is hexadecimal: readers of JSON often have nothing
// else, and it is digests.
#pragma once

#include <nlohmann/json.hpp>

#include "core/io/record/cdr.hpp"

namespace arcbid {

class JsonWriter {
 public:
  template <class T>
  void operator()(std::string_view field, const T& value) {
    out_[std::string(field)] = json(value);
  }
  template <std::size_t n, class... Ts>
  void choice(const std::array<std::string_view, n>& names, const std::variant<Ts...>& chosen) {
    const std::string name(names[chosen.index()]);
    std::visit([&](const auto& value) { out_[name] = json(value); }, chosen);
  }
  template <class T>
  static nlohmann::json of(const T& record) {
    JsonWriter writer;
    fields(writer, record);
    return std::move(writer.out_);
  }

 private:
  template <class T>
  static nlohmann::json json(const T& value) {
    if constexpr (std::same_as<T, std::uint64_t>) {
      constexpr std::uint64_t most_exact = std::uint64_t{1} << 53;
      return value <= most_exact ? nlohmann::json(value)
                                 : nlohmann::json(fmt::format("{:016x}", value));
    } else if constexpr (std::same_as<T, bool> || Number<T> || std::same_as<T, std::string>)
      return value;
    else if constexpr (std::same_as<T, PolicyKind> || std::same_as<T, ScoreKind> ||
                       std::same_as<T, TourSolver> || std::same_as<T, TradesKind> ||
                       std::same_as<T, Payload> || std::same_as<T, NoBidderReason>)
      return name_of(value);
    else if constexpr (std::same_as<T, ArcKind>)
      return name(value);
    else if constexpr (std::is_enum_v<T>)
      return static_cast<int>(value);
    else if constexpr (IsId<T>)
      return value.value;
    else if constexpr (std::same_as<T, Vec3>)
      return {value.x(), value.y(), value.z()};
    else
      return of(value);
  }
  template <class T>
  static nlohmann::json json(const std::vector<T>& values) {
    nlohmann::json out = nlohmann::json::array();
    for (const T& value : values) out.push_back(json(value));
    return out;
  }
  template <class T>
  static nlohmann::json json(const std::optional<T>& value) {
    return value ? json(*value) : nlohmann::json(nullptr);
  }

  nlohmann::json out_ = nlohmann::json::object();
};

}  // namespace arcbid
