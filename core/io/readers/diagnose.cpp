// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/diagnose.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace arcbid::readers {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 6> kUnits{{{"m", 1.0},
                                      {"cm", 0.01},
                                      {"mm", 0.001},
                                      {"ft", 0.3048},
                                      {"us-ft", 1200.0 / 3937.0},
                                      {"in", 0.0254}}};

// Sizes along the longest axis. Most bridges, aircraft and buildings lie well inside.
constexpr double kLeast_m = 0.5, kSmall_m = 2.0, kLarge_m = 3'000.0, kMost_m = 20'000.0;

/// From here on, coordinates are taken as a map's and moved.
constexpr double kFarFromOrigin_m = 10'000.0;

Eigen::AlignedBox3d bounding_box(const RawGeometry& raw) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : raw.points) box.extend(point);
  return box;
}

std::string length(double metres) {
  if (metres >= 1000) return grouped(static_cast<std::uint64_t>(std::llround(metres))) + " m";
  return fmt::format("{:.3g} m", metres);
}

/// "say --unit mm (30 m) or --unit in (762 m)": the units that give the longest side a usual
/// length.
std::string other_units(double longest_m, const ReadOptions& options) {
  const double in_file = longest_m / metres_per_unit(options);
  std::string out;
  for (const Unit& unit : kUnits) {
    const double metres = in_file * unit.metres;
    if (unit.name == options.unit || unit.name == "us-ft") continue;
    if (metres < kSmall_m || metres > kLarge_m) continue;
    out += fmt::format("{} --unit {} ({})", out.empty() ? "say" : " or", unit.name, length(metres));
  }
  return out.empty() ? "scale the file to one of the legal units m, cm, mm, ft, us-ft, in" : out;
}

/// A rotation that maps the axis `up` onto z and keeps the frame right-handed.
Eigen::Matrix3d to_z_up(char up) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (up == 'y') rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == 'x') rotation << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return rotation;
}

/// A structure far from 0, less than a degree wide, and hundreds of times taller than wide.
bool looks_like_degrees(const Eigen::AlignedBox3d& box) {
  const Vec3 size = box.sizes(), centre = box.center();
  const double width = std::max(size.x(), size.y());
  return width > 0 && width <= 1 && std::abs(centre.x()) <= 180 && std::abs(centre.y()) <= 90 &&
         centre.head<2>().norm() > 50 * width && size.z() > 500 * width;
}

}  // namespace

double metres_per_unit(const ReadOptions& options) {
  if (options.up != 'x' && options.up != 'y' && options.up != 'z') {
    throw InputError(fmt::format("up {}: legal are x, y, z", in_quotes({&options.up, 1})));
  }
  for (const Unit& unit : kUnits) {
    if (unit.name == options.unit) return unit.metres;
  }
  throw InputError(
      fmt::format("unit {}: legal are m, cm, mm, ft, us-ft, in", in_quotes(options.unit)));
}

void refuse_degrees(const Source& source, const RawGeometry& raw) {
  const Eigen::AlignedBox3d box = bounding_box(raw);
  if (!raw.in_degrees && !looks_like_degrees(box)) return;
  const Vec3 centre = box.center();
  const int zone = std::clamp(static_cast<int>((centre.x() + 180.0) / 6.0) + 1, 1, 60);
  fail(source,
       "x {:.4f} to {:.4f}, y {:.4f} to {:.4f} are degrees of longitude and latitude, not lengths: "
       "project them to metres first (pdal translate IN OUT reprojection "
       "--filters.reprojection.out_srs=EPSG:{}{:02})",
       box.min().x(), box.max().x(), box.min().y(), box.max().y(), centre.y() < 0 ? 327 : 326,
       zone);
}

void to_local_frame(RawGeometry& raw, const ReadOptions& options) {
  const Eigen::Matrix3d transform = metres_per_unit(options) * to_z_up(options.up);
  if (transform != Eigen::Matrix3d::Identity()) {
    for (Vec3& point : raw.points) point = transform * point;
  }
  Vec3 shift = bounding_box(raw).center();
  shift.z() = 0;
  if (shift.cwiseAbs().maxCoeff() <= kFarFromOrigin_m) return;
  for (Vec3& point : raw.points) point -= shift;
  raw.warnings.push_back(fmt::format(
      "far from the origin: moved by ({:.3f}, {:.3f}, 0) m so that the centre is at x = y = 0",
      -shift.x(), -shift.y()));
}

void judge_extents(const Source& source, RawGeometry& raw, const ReadOptions& options) {
  const Vec3 size = bounding_box(raw).sizes();
  const double longest = size.maxCoeff();
  if (longest == 0) fail(source, "all points lie on one spot: nothing to inspect");
  const std::string extents =
      fmt::format("{} by {} by {} tall", length(size.x()), length(size.y()), length(size.z()));
  if (longest > kMost_m || longest < kLeast_m) {
    fail(source, "the structure is {}, read in {}: legal are {} to {}; is the unit wrong? {}",
         extents, options.unit, length(kLeast_m), length(kMost_m), other_units(longest, options));
  }
  const bool wrong_unit = raw.declared_unit && *raw.declared_unit != options.unit;
  if (wrong_unit) {
    raw.warnings.push_back(
        fmt::format("the file says that its unit is {}, read in {}: say --unit {}",
                    *raw.declared_unit, options.unit, *raw.declared_unit));
  } else if (longest > kLarge_m || longest < kSmall_m) {
    raw.warnings.push_back(fmt::format("the structure is {}, read in {}: is the unit wrong? {}",
                                       extents, options.unit, other_units(longest, options)));
  }
  const double width = std::max(size.x(), size.y());
  if (size.z() > 3 * width) {
    raw.warnings.push_back(fmt::format("the structure is {}: is another axis up? say --up {}",
                                       extents, options.up == 'z' ? "y" : "z"));
  }
  if (size.z() == 0) raw.warnings.push_back("all points lie in one horizontal plane");
}

}  // namespace arcbid::readers
