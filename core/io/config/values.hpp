// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/arcs/arc.hpp"
#include "core/base/ids.hpp"
#include "core/io/config/report.hpp"

namespace arcbid::yaml {

/// A value in a file: the node, where it stands, and its full path ("fleet.uavs[1].speed_mps").
struct Place {
  YAML::Node node;
  YAML::Mark at;
  std::string path;
};

/// A kind of value: what is legal, in words, and how it is read and printed. `read` leaves the
/// value alone when it reports a problem; `print` gives YAML that `read` takes back to the same
/// value.
template <class T>
struct Kind {
  std::string legal;  ///< "a number in [0.1, 30]"
  std::function<void(const Place&, T&, Report&)> read;
  std::function<std::string(const T&)> print;
};

/// The scalar as the file writes it, for messages: text in quotes keeps them.
std::string shown(const YAML::Node& scalar);

/// False, and a problem in the report, for anything but a scalar.
bool is_scalar(const Place& place, const std::string& legal, Report& report);

/// A finite number in [low, high], whole if `whole`; none, and a problem in the report, otherwise.
std::optional<double> read_number(const Place& place, double low, double high, bool whole,
                                  const std::string& legal, Report& report);

/// Limits are exact up to 2^53, which no key comes near.
template <class T>
Kind<T> number(double low, double high) {
  constexpr bool whole = std::integral<T>;
  const std::string legal =
      fmt::format("{} in [{}, {}]", whole ? "an integer" : "a number", low, high);
  return {legal,
          [=](const Place& place, T& value, Report& report) {
            if (const auto n = read_number(place, low, high, whole, legal, report))
              value = static_cast<T>(*n);
          },
          [](const T& value) { return fmt::format("{}", value); }};
}

/// A number, or `word` for "none".
template <class T>
Kind<std::optional<T>> number_or(const std::string& word, double low, double high) {
  const Kind<T> plain = number<T>(low, high);
  const std::string legal = plain.legal + " or " + word;
  return {legal,
          [=](const Place& place, std::optional<T>& value, Report& report) {
            if (place.node.IsScalar() && place.node.Scalar() == word)
              value.reset();
            else if (const auto n = read_number(place, low, high, std::integral<T>, legal, report))
              value = static_cast<T>(*n);
          },
          [=](const std::optional<T>& value) { return value ? plain.print(*value) : word; }};
}

/// One of a few words.
template <class T>
Kind<T> choice(const std::vector<std::pair<std::string, T>>& choices) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) words.push_back(word);
  const std::string legal = fmt::format("one of {}", fmt::join(words, ", "));
  return {legal,
          [=](const Place& place, T& value, Report& report) {
            if (!is_scalar(place, legal, report)) return;
            for (const auto& [word, meant] : choices)
              if (place.node.Scalar() == word) {
                value = meant;
                return;
              }
            report.problem(place.at, place.path,
                           fmt::format("{} is not {}{}", shown(place.node), legal,
                                       did_you_mean(place.node.Scalar(), words)));
          },
          [=](const T& value) {
            for (const auto& [word, meant] : choices)
              if (meant == value) return word;
            return std::string("?");
          }};
}

/// The enumerators of E by their names, which stand in the order of their values.
template <class E, std::size_t n>
std::vector<std::pair<std::string, E>> enumerators(const std::array<std::string_view, n>& names) {
  std::vector<std::pair<std::string, E>> out;
  for (std::size_t i = 0; i < n; ++i) out.emplace_back(names[i], static_cast<E>(i));
  return out;
}

/// true or false: the other words of YAML 1.1 (yes, on, ...) are more often mistakes.
Kind<bool> boolean();
/// A time in milliseconds, kept in nanoseconds.
Kind<TimeNs> milliseconds(double low, double high);
/// A name for people, and for folders.
Kind<std::string> title();
Kind<std::string> ipv4_address();
/// The name of a file, possibly absent.
Kind<std::optional<std::filesystem::path>> file_name();
/// [x, y, z], each within `limit_m` of 0.
Kind<Vec3> position(double limit_m);

}  // namespace arcbid::yaml
