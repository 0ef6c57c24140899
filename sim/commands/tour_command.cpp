// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/commands/tour_command.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/tsplib/tsplib.hpp"
#include "sim/commands/choices.hpp"
#include "sim/tour/rivals.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

/// The cities in the order of the tour.
json order_of(const Tour& tour, const PairedCities& instance) {
  json out = json::array();
  for (const Stop& stop : tour.stops) {
    const auto& pair = instance.pairs[stop.arc];
    out.push_back(pair[stop.reversed ? 1 : 0]);
    out.push_back(pair[stop.reversed ? 0 : 1]);
  }
  return out;
}

constexpr std::array<std::string_view, 5> solver_names{
    tour_solver_names[0], tour_solver_names[1], rival_names[0], rival_names[1], rival_names[2]};

void write(const std::string& file, const json& answer) {
  const std::string text = answer.dump() + "\n";
  if (file == "-") {
    fmt::print("{}", text);
    return;
  }
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) throw InputError(fmt::format("--json {}: cannot be written", file));
}

}  // namespace

TourCommand::TourCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "tour", "the closed tour through a TSPLIB instance whose cities are joined to arcs")),
      epochs_(TourSettings{}.epochs) {
  command_->add_option("instance", tsp_, "TSPLIB file with coordinates")->required();
  command_->add_option("--pairs", pairs_, "two cities a line: the arcs")->required();
  command_->add_option("--solver", solver_, "crsom, crsom+ls (default), or a rival: ga, aco, pso");
  command_->add_option("--deadline-ms", deadline_ms_, "how long to look, by the clock (100)")
      ->check(CLI::Range(0.0, 1e8));
  command_->add_option("--iterations", iterations_,
                       "so many iterations instead, whatever they take: the same tour every time");
  command_->add_option("--seed", seed_, "of all that is random");
  command_->add_option("--epochs", epochs_, "how often the arcs are shown to the ring, at most")
      ->check(CLI::Range(1u, 100000u));
  command_->add_option("--json", json_, "write length, seconds and order to this file, or to -");
}

Exit TourCommand::run() const {
  const auto solver = by_name<std::size_t>(solver_names, solver_);
  const PairedCities instance = read_paired_cities(tsp_, pairs_);
  // At home on an end of an arc, the best tour through home is the best tour.
  const Vec3& home_m = instance.arcs.front().first_m;
  const StraightTransit straight;
  const TourEffort effort{.deadline_s = deadline_ms_ * 1e-3, .iterations = iterations_};
  const SolvedTour solved =
      solver < tour_solver_names.size()
          ? solve_tour(
                instance.arcs, home_m, straight,
                {.solver = static_cast<TourSolver>(solver), .seed = seed_, .epochs = epochs_},
                effort)
          : solve_by(static_cast<Rival>(solver - tour_solver_names.size()), instance.arcs, home_m,
                     straight, seed_, effort);
  const json answer{{"length", solved.tour.total_m},
                    {"connecting", solved.tour.connecting_m},
                    {"seconds", solved.seconds},
                    {"iterations", solved.iterations},
                    {"solver", solver_},
                    {"seed", seed_},
                    {"arcs", instance.arcs.size()},
                    {"order", order_of(solved.tour, instance)}};
  if (!json_.empty()) write(json_, answer);
  if (json_ != "-")
    fmt::print("{:<20}{}\n{:<20}{:.4f}\n{:<20}{:.4f}\n{:<20}{:.4f}\n", "arcs", instance.arcs.size(),
               "length", solved.tour.total_m, "of it connections", solved.tour.connecting_m,
               "seconds", solved.seconds);
  return Exit::done;
}

}  // namespace arcbid
