// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/tour/ring.hpp"
#include "core/tour/tour.hpp"

namespace arcbid {

namespace {

// The paper prints no values. These were chosen on the nine matching instances of its Table 2; the
// result is flat around them. Lengths are fractions of the inputs' extent, sigma of the ring.
constexpr std::size_t kFirstNeurons = 10;
constexpr double kFirstRadius = 0.1;
constexpr double kNeuronsPerInput = 2.5;
constexpr double kGrowingShare = 0.8;  ///< of the run; then the ring only settles
constexpr double kSigmaFirst = 0.2, kSigmaLast = 0.0015;
constexpr double kEtaFirst = 0.85, kEtaLast = 0.7;

/// The input layer: home, then the centre of each arc's two end points, as fractions of their
/// largest extent. Empty when there is nothing to scale by: all coincide, or a number is not
/// finite.
std::vector<Vec3> normalised_inputs(std::span<const TourArc> arcs, const Vec3& home_m) {
  std::vector<Vec3> inputs{home_m};
  for (const TourArc& arc : arcs) inputs.push_back(0.5 * arc.first_m + 0.5 * arc.last_m);
  Vec3 low = home_m, high = home_m;
  for (const Vec3& input : inputs) {
    low = low.cwiseMin(input);
    high = high.cwiseMax(input);
  }
  const double extent = (high - low).maxCoeff();
  const auto finite = [](const Vec3& v) { return v.allFinite(); };
  if (!(extent > 0) || !std::isfinite(extent) || !std::ranges::all_of(inputs, finite)) return {};
  for (Vec3& input : inputs) input = (input - low) / extent;
  return inputs;
}

/// A quantity that falls from `first` to `last` over the epochs: first exp(-t / tau) (eqs. 16, 17).
double decayed(double first, double last, std::uint32_t epoch, std::uint32_t epochs) {
  if (epochs < 2) return first;
  const double tau = (epochs - 1) / std::log(first / last);
  return first * std::exp(-static_cast<double>(epoch) / tau);
}

void shuffle(std::vector<std::uint32_t>& order, boost::random::mt19937_64& random) {
  for (std::size_t i = order.size(); i > 1; --i) {
    boost::random::uniform_int_distribution<std::size_t> position(0, i - 1);
    std::swap(order[i - 1], order[position(random)]);
  }
}

GrowingRing trained_ring(const std::vector<Vec3>& inputs, const TourSettings& settings) {
  const double count = static_cast<double>(inputs.size());
  const Vec3 mean = std::accumulate(inputs.begin(), inputs.end(), Vec3(Vec3::Zero())) / count;
  GrowingRing ring(kFirstNeurons, mean, kFirstRadius);
  const auto full_size =
      std::max(kFirstNeurons, static_cast<std::size_t>(kNeuronsPerInput * count));
  const double growing_time = kGrowingShare * settings.epochs * count;  // in presentations
  const double growth_dt = growing_time / static_cast<double>(full_size - kFirstNeurons + 1);

  boost::random::mt19937_64 random(settings.seed);
  std::vector<std::uint32_t> presented(inputs.size());
  std::iota(presented.begin(), presented.end(), 0U);
  double t = 0, growth_t = growth_dt;
  for (std::uint32_t epoch = 0; epoch < settings.epochs; ++epoch) {
    shuffle(presented, random);
    const double sigma = decayed(kSigmaFirst, kSigmaLast, epoch, settings.epochs);
    const double eta = decayed(kEtaFirst, kEtaLast, epoch, settings.epochs);
    for (const std::uint32_t input : presented) {
      const Vec3& a = inputs[input];
      ring.pull(ring.winner(a), a, eta, sigma * static_cast<double>(ring.size()));
      t += 1;
      for (; t >= growth_t && ring.size() < full_size; growth_t += growth_dt) ring.grow();
    }
  }
  return ring;
}

}  // namespace

std::vector<std::uint32_t> crsom_order(std::span<const TourArc> arcs, const Vec3& home_m,
                                       const TourSettings& settings) {
  std::vector<std::uint32_t> order(arcs.size());
  std::iota(order.begin(), order.end(), 0U);
  if (arcs.size() <= 2) return order;  // one closed tour only, but for its sense
  const std::vector<Vec3> inputs = normalised_inputs(arcs, home_m);
  if (inputs.empty()) return order;

  GrowingRing ring = trained_ring(inputs, settings);
  using Place = std::tuple<std::size_t, double, std::uint32_t>;  // winner, along the ring, input
  std::vector<Place> places;
  for (std::uint32_t input = 0; input < inputs.size(); ++input) {
    const std::size_t winner = ring.winner(inputs[input]);
    places.emplace_back(winner, ring.along(winner, inputs[input]), input);
  }
  std::ranges::sort(places);
  const auto home = std::ranges::find(places, 0U, [](const Place& p) { return std::get<2>(p); });
  std::ranges::rotate(places, home);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = std::get<2>(places[k + 1]) - 1;
  return order;
}

}  // namespace arcbid
