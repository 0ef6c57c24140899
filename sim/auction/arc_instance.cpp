// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/arc_instance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using Json = nlohmann::json;
constexpr std::size_t most_agents = 1000, most_arcs = 100000;
constexpr double most_m = 1e6;  // farther off nothing flies

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file.string()) {
    std::ifstream in(file);
    if (!in) throw InputError(fmt::format("{}: cannot be read", file_));
    try {
      root_ = Json::parse(in);
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}: not JSON: {}", file_, error.what()));
    }
  }

  const Json& list(const char* key, std::size_t most) const {
    if (!root_.is_object() || !root_.contains(key)) refuse(key, "is missing");
    const Json& list = root_[key];
    if (!list.is_array() || list.empty() || list.size() > most)
      refuse(key, fmt::format("is not a list of 1 to {} entries", most));
    return list;
  }

  Vec3 point(const Json& value, const std::string& where) const {
    if (!value.is_array() || value.size() != 3) refuse(where, "is not [x, y, z]");
    Vec3 point;
    for (unsigned axis = 0; axis < 3; ++axis) point[axis] = number(value[axis], where);
    return point;
  }

  double number(const Json& value, const std::string& where) const {
    if (!value.is_number() || !(std::abs(value.get<double>()) <= most_m))
      refuse(where, fmt::format("{} is not a number within {:.0f} of 0", value.dump(), most_m));
    return value.get<double>();
  }

  Payload payload(const Json& value, const std::string& where) const {
    for (std::size_t n = 0; n < payload_names.size(); ++n)
      if (value == payload_names[n]) return static_cast<Payload>(n);
    refuse(where, fmt::format("{} is not one of {}", value.dump(), fmt::join(payload_names, ", ")));
  }

  [[noreturn]] void refuse(const std::string& where, const std::string& why) const {
    throw InputError(fmt::format("{}: {}: {}", file_, where, why));
  }

 private:
  std::string file_;
  Json root_;
};

Uav read_uav(const Reader& reader, const Json& entry, std::uint32_t n) {
  const std::string where = fmt::format("agents[{}]", n);
  if (!entry.is_object() || !entry.contains("home")) reader.refuse(where, "has no home");
  Uav uav{{n + 1}, reader.point(entry["home"], where + ".home")};
  const auto above_0 = [&](const char* key) {
    const std::string place = where + "." + key;
    const double value = reader.number(entry[key], place);
    if (!(value > 0)) reader.refuse(place, fmt::format("{} is not above 0", value));
    return value;
  };
  if (entry.contains("speed_mps")) uav.speed_mps = above_0("speed_mps");
  if (entry.contains("endurance_s")) uav.endurance_s = above_0("endurance_s");
  if (entry.contains("payload")) uav.payload = reader.payload(entry["payload"], where + ".payload");
  return uav;
}

Arc read_arc(const Reader& reader, const Json& entry, std::uint32_t n) {
  const std::string where = fmt::format("arcs[{}]", n);
  Arc arc;
  arc.id = {n};
  if (entry.is_object() && entry.contains("payload"))
    arc.payload = reader.payload(entry["payload"], where + ".payload");
  const Json& points = entry.is_object() && entry.contains("points") ? entry["points"] : entry;
  if (!points.is_array()) reader.refuse(where, "is not a list of points, or an object with points");
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 at_m = reader.point(points[k], fmt::format("{}[{}]", where, k));
    if (arc.waypoints.empty() || arc.waypoints.back().position_m != at_m)
      arc.waypoints.push_back({at_m, -Vec3::UnitZ()});
  }
  if (arc.waypoints.size() < 2) reader.refuse(where, "has fewer than two distinct points");
  return arc;
}

}  // namespace

Mission read_arc_instance(const std::filesystem::path& file) {
  const Reader reader(file);
  Mission mission;
  mission.name = file.stem().string();
  for (const Json& entry : reader.list("agents", most_agents))
    mission.fleet.push_back(
        read_uav(reader, entry, static_cast<std::uint32_t>(mission.fleet.size())));
  for (const Json& entry : reader.list("arcs", most_arcs))
    mission.arcs.push_back(
        read_arc(reader, entry, static_cast<std::uint32_t>(mission.arcs.size())));
  return mission;
}

}  // namespace arcbid
