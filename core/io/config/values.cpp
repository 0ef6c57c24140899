// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/config/values.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace arcbid::yaml {
namespace {

// yaml-cpp tags plain scalars "?" and quoted ones "!".
bool is_quoted(const YAML::Node& scalar) {
  return scalar.Tag() == "!";
}

std::string quoted(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

/// A decimal number as YAML 1.2 writes it; infinite when too large for a double.
std::optional<double> to_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return HUGE_VAL;
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value + 0.0;  // -0 becomes 0
}

Kind<std::string> text(const std::string& legal, bool (*is_legal)(const std::string&)) {
  return {legal,
          [=](const Place& place, std::string& value, Report& report) {
            if (!is_scalar(place, legal, report)) return;
            if (is_legal(place.node.Scalar()))
              value = place.node.Scalar();
            else
              report.problem(place.at, place.path,
                             fmt::format("{} is not {}", shown(place.node), legal));
          },
          quoted};
}

}  // namespace

std::string shown(const YAML::Node& scalar) {
  const std::string text = shown(scalar.Scalar());
  return is_quoted(scalar) ? fmt::format("\"{}\"", text) : text;
}

bool is_scalar(const Place& place, const std::string& legal, Report& report) {
  if (place.node.IsScalar()) return true;
  if (place.node.IsNull())
    report.problem(place.at, place.path, "has no value; legal: " + legal);
  else
    report.problem(place.at, place.path,
                   fmt::format("a {} is not {}", place.node.IsMap() ? "mapping" : "list", legal));
  return false;
}

std::optional<double> read_number(const Place& place, double low, double high, bool whole,
                                  const std::string& legal, Report& report) {
  if (!is_scalar(place, legal, report)) return std::nullopt;
  const auto value = is_quoted(place.node) ? std::nullopt : to_number(place.node.Scalar());
  if (value && (*value < low || *value > high))
    report.problem(place.at, place.path,
                   fmt::format("{} is outside [{}, {}]", shown(place.node), low, high));
  else if (!value || (whole && *value != std::floor(*value)))
    report.problem(place.at, place.path, fmt::format("{} is not {}", shown(place.node), legal));
  else
    return value;
  return std::nullopt;
}

Kind<bool> boolean() {
  return choice<bool>({{"true", true}, {"false", false}});
}

Kind<TimeNs> milliseconds(double low, double high) {
  constexpr double ns_per_ms = 1e6;
  const Kind<double> ms = number<double>(low, high);
  return {ms.legal,
          [=](const Place& place, TimeNs& value, Report& report) {
            if (const auto n = read_number(place, low, high, false, ms.legal, report))
              value = std::llround(*n * ns_per_ms);
          },
          [=](const TimeNs& value) { return ms.print(static_cast<double>(value) / ns_per_ms); }};
}

Kind<std::string> title() {
  return text("1 to 64 printable characters without / or \\", [](const std::string& name) {
    return !name.empty() && name.size() <= 64 && name.front() != '.' &&
           std::none_of(name.begin(), name.end(), [](char c) {
             return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
           });
  });
}

Kind<std::string> ipv4_address() {
  return text("an IPv4 address such as 192.168.1.10", [](const std::string& address) {
    in_addr parsed;
    return inet_pton(AF_INET, address.c_str(), &parsed) == 1;
  });
}

Kind<std::optional<std::filesystem::path>> file_name() {
  const Kind<std::string> name =
      text("a file name", [](const std::string& t) { return !t.empty() && t.size() < 4096; });
  return {name.legal,
          [=](const Place& place, std::optional<std::filesystem::path>& value, Report& report) {
            std::string read;
            name.read(place, read, report);
            if (!read.empty()) value = read;
          },
          [=](const std::optional<std::filesystem::path>& value) {
            return value ? name.print(value->string()) : "";
          }};
}

Kind<Vec3> position(double limit_m) {
  const Kind<double> coordinate = number<double>(-limit_m, limit_m);
  const std::string legal = fmt::format("a list [x, y, z], each {}", coordinate.legal);
  return {legal,
          [=](const Place& place, Vec3& value, Report& report) {
            if (!place.node.IsSequence() || place.node.size() != 3) {
              const std::string given = place.node.IsSequence()
                                            ? fmt::format("a list of {}", place.node.size())
                                        : place.node.IsScalar() ? shown(place.node)
                                        : place.node.IsMap()    ? "a mapping"
                                                                : "nothing";
              report.problem(place.at, place.path, fmt::format("{} is not {}", given, legal));
              return;
            }
            for (int axis = 0; axis < 3; ++axis) {
              const YAML::Node node = place.node[axis];
              coordinate.read({node, node.Mark(), fmt::format("{}[{}]", place.path, axis)},
                              value[axis], report);
            }
          },
          [](const Vec3& value) {
            return fmt::format("[{}, {}, {}]", value.x(), value.y(), value.z());
          }};
}

}  // namespace arcbid::yaml
