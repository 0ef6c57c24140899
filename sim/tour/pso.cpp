// SPDX-License-Identifier: GPL-3.0-or-later
// Particle swarm optimisation over permutations (after Pan, Tasgetiren, Liang 2008): a particle
// moves by a change of its own, then toward the best it has been, then toward the best of its
// neighbours; to move toward an order is to take a stretch of it.
#include <utility>

#include "sim/tour/order_moves.hpp"
#include "sim/tour/rivals.hpp"

namespace arcbid {
namespace {

constexpr std::size_t kParticles = 40, kReach = 10;  ///< neighbours on either side, on a ring
constexpr std::uint32_t kOwnPercent = 90, kBestPercent = 50, kNeighbourPercent = 50;

using Order = OrderSearch::Order;

class Swarm {
 public:
  Swarm(OrderSearch& search, std::uint64_t seed) : search_(search), moves_(seed) {
    for (std::size_t n = 0; n < kParticles; ++n) {
      Order order = moves_.shuffled(search.arcs());
      const double length_m = search.length_m(order);
      particles_.push_back({order, std::move(order), length_m});
    }
  }

  void move() {
    for (std::size_t n = 0; n < kParticles; ++n) {
      Particle& particle = particles_[n];
      if (moves_.happens(kOwnPercent)) moves_.mutate(particle.at);
      if (moves_.happens(kBestPercent)) particle.at = moves_.crossed(particle.best, particle.at);
      if (moves_.happens(kNeighbourPercent))
        particle.at = moves_.crossed(best_near(n), particle.at);
      const double length_m = search_.length_m(particle.at);
      if (length_m >= particle.best_m) continue;
      particle.best = particle.at;
      particle.best_m = length_m;
    }
  }

 private:
  struct Particle {
    Order at, best;
    double best_m = 0;
  };

  const Order& best_near(std::size_t n) const {
    const Particle* best = &particles_[n];
    for (std::size_t d = 1; d <= kReach; ++d)
      for (const std::size_t other : {(n + d) % kParticles, (n + kParticles - d) % kParticles})
        if (particles_[other].best_m < best->best_m) best = &particles_[other];
    return best->best;
  }

  OrderSearch& search_;
  OrderMoves moves_;
  std::vector<Particle> particles_;
};

}  // namespace

void search_by_pso(OrderSearch& search, std::uint64_t seed, const GoesOn& goes_on) {
  Swarm swarm(search, seed);
  do swarm.move();
  while (goes_on());
}

}  // namespace arcbid
