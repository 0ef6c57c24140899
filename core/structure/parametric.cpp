// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structure/parametric.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/structure/validate.hpp"

namespace arcbid {

namespace {

constexpr int kRibSegments = 32;

/// Closed solids with six quadrilateral faces, collected as triangles that face outward.
class Solids {
 public:
  /// Corner k is at the high end of x, y, z where bits 0, 1, 2 of k are set. A solid that goes on
  /// beyond its low or high end of x has no face there.
  void add(const std::array<Vec3, 8>& corners, bool low_end = true, bool high_end = true) {
    static constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    mesh_.points.insert(mesh_.points.end(), corners.begin(), corners.end());
    for (std::size_t face = low_end ? 0 : 1; face < kFaces.size(); ++face) {
      if (face == 1 && !high_end) continue;
      const auto& [a, b, c, d] = kFaces[face];
      mesh_.triangles.push_back({first + a, first + b, first + c});
      mesh_.triangles.push_back({first + a, first + c, first + d});
    }
  }
  void add_box(const Vec3& low, const Vec3& high) {
    std::array<Vec3, 8> corners;
    for (std::size_t k = 0; k < 8; ++k)
      corners[k] = {(k & 1 ? high : low).x(), (k & 2 ? high : low).y(), (k & 4 ? high : low).z()};
    add(corners);
  }
  Structure take() { return std::move(mesh_); }

 private:
  Structure mesh_;
};

double soffit_m(const ParametricBridge& b) {
  return b.deck_height_m - b.deck_thickness_m;
}
double girder_bottom_m(const ParametricBridge& b) {
  return soffit_m(b) - (b.girders > 0 ? b.girder_depth_m : 0);
}

void require_counts(const ParametricBridge& b) {
  if (b.piers > 1000)
    throw InputError(fmt::format("parametric.piers: {} is outside [0, 1000]", b.piers));
  if (b.girders > 100)
    throw InputError(fmt::format("parametric.girders: {} is outside [0, 100]", b.girders));
  if (b.kind == BridgeKind::towers && b.piers == 0)
    throw InputError("parametric.piers: 0 is outside [1, 1000] for a bridge with towers");
}

void validate(const ParametricBridge& b) {
  require_counts(b);
  require_range("parametric.length_m", b.length_m, 1, 20'000);
  require_range("parametric.width_m", b.width_m, 1, 200);
  require_range("parametric.deck_height_m", b.deck_height_m, 0.5, 1000);
  require_range("parametric.deck_thickness_m", b.deck_thickness_m, 0.05, b.deck_height_m);
  if (b.girders > 0)
    require_range("parametric.girder_depth_m", b.girder_depth_m, 0.05, soffit_m(b));
  const double pier_room_m = b.length_m / (b.piers + 1);
  if (b.piers > 0 || b.kind == BridgeKind::arch)
    require_range("parametric.pier_width_m", b.pier_width_m, 0.05, pier_room_m);
  if (b.kind == BridgeKind::towers)
    require_range("parametric.tower_height_m", b.tower_height_m, b.deck_height_m, 2000);
  if (b.kind == BridgeKind::arch)
    require_range("parametric.tower_height_m", b.tower_height_m, b.pier_width_m, 2000);
}

/// Deck and girders: a girder is a quarter as wide as its share of the deck.
void add_span(const ParametricBridge& b, Solids& solids) {
  const double x = b.length_m / 2, y = b.width_m / 2;
  solids.add_box({-x, -y, soffit_m(b)}, {x, y, b.deck_height_m});
  const double share_m = b.width_m / std::max(b.girders, 1u);
  for (std::uint32_t g = 0; g < b.girders; ++g) {
    const double middle = -y + (g + 0.5) * share_m;
    solids.add_box({-x, middle - share_m / 8, girder_bottom_m(b)},
                   {x, middle + share_m / 8, soffit_m(b)});
  }
}

/// x of support k: they part the length into equal spans.
double support_x(const ParametricBridge& b, std::uint32_t k) {
  return -b.length_m / 2 + b.length_m * (k + 1) / (b.piers + 1);
}

/// Walls across the bridge, three fifths of its width, from the ground to the span.
void add_piers(const ParametricBridge& b, Solids& solids) {
  const Vec3 half(b.pier_width_m / 2, 0.3 * b.width_m, 0);
  for (std::uint32_t k = 0; k < b.piers; ++k) {
    const Vec3 foot(support_x(b, k), 0, 0);
    solids.add_box(foot - half, foot + half + Vec3(0, 0, girder_bottom_m(b)));
  }
}

/// Portal frames: a leg on each side of the deck, a beam under the span and one at the top.
void add_towers(const ParametricBridge& b, Solids& solids) {
  const double w = b.pier_width_m, inner = b.width_m / 2, outer = inner + w;
  for (std::uint32_t k = 0; k < b.piers; ++k) {
    const double x = support_x(b, k), low = x - w / 2, high = x + w / 2;
    solids.add_box({low, -outer, 0}, {high, -inner, b.tower_height_m});
    solids.add_box({low, inner, 0}, {high, outer, b.tower_height_m});
    const double beam_m = std::min(w, girder_bottom_m(b));
    if (beam_m > 0)
      solids.add_box({low, -inner, girder_bottom_m(b) - beam_m}, {high, inner, girder_bottom_m(b)});
    if (b.tower_height_m - w > b.deck_height_m)
      solids.add_box({low, -inner, b.tower_height_m - w}, {high, inner, b.tower_height_m});
  }
}

/// Two ribs beside the deck: parabolas from the ground at its ends to the crown.
void add_ribs(const ParametricBridge& b, Solids& solids) {
  const double depth = b.pier_width_m, half = b.length_m / 2;
  const auto top_m = [&](int i) {
    const double t = 2.0 * i / kRibSegments - 1;
    return depth + (b.tower_height_m - depth) * (1 - t * t);
  };
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < kRibSegments; ++i) {
      const double y0 = side * b.width_m / 2, y1 = side * (b.width_m / 2 + b.pier_width_m);
      std::array<Vec3, 8> corners;
      for (std::size_t k = 0; k < 8; ++k) {
        const int section = i + static_cast<int>(k & 1);
        corners[k] = {-half + b.length_m * section / kRibSegments,
                      k & 2 ? std::max(y0, y1) : std::min(y0, y1),
                      top_m(section) - (k & 4 ? 0 : depth)};
      }
      solids.add(corners, i == 0, i + 1 == kRibSegments);
    }
}

}  // namespace

Structure generate(const ParametricBridge& bridge) {
  validate(bridge);
  Solids solids;
  add_span(bridge, solids);
  if (bridge.kind == BridgeKind::towers)
    add_towers(bridge, solids);
  else
    add_piers(bridge, solids);
  if (bridge.kind == BridgeKind::arch) add_ribs(bridge, solids);
  return solids.take();
}

}  // namespace arcbid
