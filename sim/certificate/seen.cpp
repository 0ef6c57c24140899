// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/certificate/seen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim/certificate/parallel.hpp"

namespace arcbid::certificate {
namespace {

/// Samples of one cell of space, and all stations from which one of them may be in range.
struct Neighbourhood {
  std::vector<std::uint32_t> samples, stations;
};

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Vec3& at, double cell_m) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<std::int64_t>(std::floor(at[axis] / cell_m));
  return cell;
}

std::vector<Neighbourhood> neighbourhoods(const std::vector<Station>& stations,
                                          const std::vector<Sample>& samples, double range_m) {
  const double cell_m = 0.5 * range_m;
  std::map<Cell, Neighbourhood> cells;
  for (std::uint32_t s = 0; s < samples.size(); ++s)
    cells[cell_of(samples[s].position_m, cell_m)].samples.push_back(s);
  std::map<Cell, std::vector<std::uint32_t>> stations_in;
  for (std::uint32_t s = 0; s < stations.size(); ++s)
    stations_in[cell_of(stations[s].position_m, cell_m)].push_back(s);
  std::vector<Neighbourhood> out;
  constexpr std::int64_t reach = 2;  // cells of half a range: what is in range is no farther
  for (auto& [cell, here] : cells) {
    for (std::int64_t dx = -reach; dx <= reach; ++dx)
      for (std::int64_t dy = -reach; dy <= reach; ++dy)
        for (std::int64_t dz = -reach; dz <= reach; ++dz) {
          const auto at = stations_in.find({cell[0] + dx, cell[1] + dy, cell[2] + dz});
          if (at != stations_in.end())
            here.stations.insert(here.stations.end(), at->second.begin(), at->second.end());
        }
    if (!here.stations.empty()) out.push_back(std::move(here));
  }
  return out;
}

/// Looks from one sample, eight stations at a time.
class Looking {
 public:
  Looking(const Sample& sample, const SightLines& lines, Seen& seen)
      : sample_(sample), lines_(lines), seen_(seen) {}

  void add(const Station& station) {
    const Vec3 ray = station.position_m - sample_.eye_m;
    rays_.lengths_m[filled_] = ray.norm();
    rays_.directions[filled_] = ray / rays_.lengths_m[filled_];
    is_proper_[filled_] = station.is_proper;
    rays_.asked |= static_cast<std::uint8_t>(1u << filled_);
    if (++filled_ == Rays::size) ask();
  }
  void ask() {
    const std::uint8_t open = filled_ > 0 ? lines_.open(sample_.eye_m, rays_) : 0;
    for (std::size_t r = 0; r < filled_; ++r) {
      if ((open >> r & 1) == 0) continue;
      ++seen_.times;
      seen_.properly = seen_.properly || is_proper_[r];
    }
    filled_ = 0;
    rays_.asked = 0;
  }

 private:
  const Sample& sample_;
  const SightLines& lines_;
  Seen& seen_;
  Rays rays_{};
  std::array<bool, Rays::size> is_proper_{};
  std::size_t filled_ = 0;
};

/// Asks the stations one by one that the sensor's limits leave; stops at the first proper one that
/// sees the sample unless all are to be counted.
void look(const Sample& sample, const std::vector<Station>& stations,
          const std::vector<std::uint32_t>& candidates, const Sensing& sensing,
          const SightLines& lines, bool counting, Seen& seen) {
  Looking looking(sample, lines, seen);
  for (const std::uint32_t number : candidates) {
    const Station& station = stations[number];
    if (station.counts != counting) continue;
    if (sensing.shows(station.position_m, station.look, sample.position_m, sample.normal))
      looking.add(station);
    if (!counting && seen.properly) return;
  }
  looking.ask();
}

}  // namespace

std::vector<Sample> both_sides(const std::vector<SurfacePoint>& points, double least_offset_m) {
  std::vector<Sample> samples;
  samples.reserve(2 * points.size());
  for (const SurfacePoint& p : points)
    for (const double side : {1.0, -1.0}) {
      const Vec3 normal = side * p.normal;
      const double offset_m = std::max(least_offset_m, p.offset_m);
      samples.push_back({p.position_m, normal, p.position_m + offset_m * normal, p.area_m2});
    }
  return samples;
}

std::vector<Seen> seen_from(const std::vector<Station>& stations,
                            const std::vector<Sample>& samples, const Sensing& sensing,
                            const SightLines& lines, unsigned threads) {
  std::vector<Seen> all(samples.size());
  const std::vector<Neighbourhood> cells =
      neighbourhoods(stations, samples, sensing.sensor().range_m);
  in_chunks(cells.size(), 1, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c)
      for (const std::uint32_t s : cells[c].samples) {
        Seen& seen = all[s];
        look(samples[s], stations, cells[c].stations, sensing, lines, true, seen);
        if (seen.properly) continue;
        const std::uint32_t counted = seen.times;
        look(samples[s], stations, cells[c].stations, sensing, lines, false, seen);
        seen.times = std::max(counted, seen.times > 0 ? 1u : 0u);
      }
  });
  return all;
}

void judge(std::vector<Station>& stations, const FreeSpace& space, unsigned threads) {
  in_chunks(stations.size(), 64, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first; s < last; ++s)
      stations[s].is_proper = space.place(stations[s].position_m) == Place::flyable;
  });
}

}  // namespace arcbid::certificate
