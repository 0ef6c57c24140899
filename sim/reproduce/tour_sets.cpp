// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/reproduce/tour_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <fstream>
#include <sstream>
#include <tuple>

#include "core/base/error.hpp"
#include "core/io/tsplib/tsplib.hpp"

namespace arcbid::reproduce {
namespace {

constexpr std::string_view kNotInTsplib = "rand200";  // the paper's own, and never published

std::vector<Vec3> random_cities(std::uint32_t count) {
  boost::random::mt19937_64 random(count);
  boost::random::uniform_real_distribution<double> place(0, 1000);
  std::vector<Vec3> cities;
  for (std::uint32_t n = 0; n < count; ++n) {
    const double x = place(random);
    cities.emplace_back(x, place(random), 0);
  }
  return cities;
}

/// The best arc-constrained tour of matched pairs: columns name, pairing, M, arc_total,
/// best_tour_length.
std::optional<double> best_known(const std::filesystem::path& file, std::string_view name) {
  std::ifstream in(file);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream row(line);
    std::array<std::string, 5> field;
    for (std::string& text : field) std::getline(row, text, ',');
    if (field[0] != name || field[1] != "matching") continue;
    std::istringstream text(field[4]);
    double length = 0;
    if (!(text >> length) || !(length > 0))
      throw InputError(fmt::format("{}:{}: '{}' is no length of a tour; legal: a number above 0",
                                   file.string(), number, field[4]));
    return length;
  }
  return std::nullopt;
}

}  // namespace

void require_tsplib(const std::filesystem::path& folder) {
  std::string missing;
  for (const paper::TourSet& set : paper::kTourSets)
    if (set.name != kNotInTsplib &&
        !std::filesystem::exists(folder / fmt::format("{}.tsp", set.name)))
      missing += fmt::format("{}{}.tsp", missing.empty() ? "" : ", ", set.name);
  if (!missing.empty())
    throw InputError(fmt::format(
        "--tsplib {}: has no {}; legal is a directory with these files of TSPLIB95 (G. Reinelt, "
        "1991)",
        folder.string(), missing));
}

ArcSet arc_set(const paper::TourSet& set, const std::optional<std::filesystem::path>& folder) {
  const std::string name(set.name);
  if (!folder || !std::filesystem::exists(*folder / (name + ".tsp")))
    return {fmt::format("rand{}", set.cities), nearest_pairs(random_cities(set.cities)),
            std::nullopt, true};
  const auto tsp = *folder / (name + ".tsp"), pairs = *folder / (name + ".matching.pairs");
  if (!std::filesystem::exists(pairs))
    return {name, nearest_pairs(read_cities(tsp)), std::nullopt, false};
  return {name, read_paired_cities(tsp, pairs).arcs,
          best_known(*folder / "arc_reference.csv", name), false};
}

std::vector<TourArc> nearest_pairs(std::vector<Vec3> cities) {
  if (cities.size() % 2 == 1) cities.push_back(Vec3(cities.back()));
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < cities.size(); ++a)
    for (std::size_t b = a + 1; b < cities.size(); ++b)
      pairs.emplace_back((cities[a] - cities[b]).norm(), a, b);
  std::ranges::sort(pairs);
  std::vector<bool> is_taken(cities.size());
  std::vector<TourArc> arcs;
  for (const auto& [length, a, b] : pairs) {
    if (is_taken[a] || is_taken[b]) continue;
    is_taken[a] = is_taken[b] = true;
    arcs.push_back({cities[a], cities[b], length});
  }
  return arcs;
}

}  // namespace arcbid::reproduce
