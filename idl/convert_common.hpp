// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "idl/convert.hpp"

/// Shared by the two halves of the conversion.
namespace arcbid::convert {

/// The first reason to refuse a sample, if any. Once there is one, later checks don't replace it.
class Verdict {
 public:
  explicit Verdict(std::uint32_t schema_version) {
    if (schema_version == kUndecodable)
      refuse("payload cannot be decoded");
    else
      require(schema_version == wire::SCHEMA_VERSION, "schema_version", schema_version);
  }

  template <class Value>
  void require(bool holds, const char* field, const Value& value) {
    if (!holds) refuse(fmt::format("{} = {} is not allowed", field, value));
  }
  void finite(const char* field, double value) { require(std::isfinite(value), field, value); }
  void at_most(const char* field, std::size_t size, std::size_t limit) {
    if (size > limit)
      refuse(fmt::format("{} has {} entries, at most {} are allowed", field, size, limit));
  }
  void text(const char* field, const std::string& value) { at_most(field, value.size(), kMaxText); }

  bool accepted() const { return !reason_; }

  /// `value`, unless there was a reason to refuse it.
  template <class T>
  Decoded<T> on(T value) const {
    if (reason_) return *reason_;
    return value;
  }

 private:
  void refuse(std::string reason) {
    if (!reason_) reason_ = std::move(reason);
  }
  std::optional<std::string> reason_;
};

inline std::array<double, 3> encode(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

inline Vec3 decode(const std::array<double, 3>& v, const char* field, Verdict& verdict) {
  for (const double x : v) verdict.finite(field, x);
  return {v[0], v[1], v[2]};
}

/// Generated enumerations start at 0 without gaps and list core's values in core's order. A decoder
/// lets any number through.
template <class Core, class Wire>
Core enumerator(Wire value, Wire last, const char* field, Verdict& verdict) {
  const auto number = static_cast<std::uint32_t>(value);
  verdict.require(number <= static_cast<std::uint32_t>(last), field, number);
  return static_cast<Core>(number);
}

std::vector<wire::Waypoint> encode(const std::vector<Waypoint>& waypoints);
std::vector<Waypoint> decode(const std::vector<wire::Waypoint>& waypoints, Verdict& verdict);

}  // namespace arcbid::convert
