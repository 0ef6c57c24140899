// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tour/tsplib.hpp"

#include <array>
#include <fstream>
#include <sstream>

#include "core/io/tsplib/tsplib.hpp"

namespace arcbid {

namespace {

double read_best_tour_m(const std::filesystem::path& file, const std::string& name,
                        const std::string& pairing) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    std::array<std::string, 5> field;  // name, pairing, M, arc_total, best_tour_length
    for (std::string& text : field) std::getline(row, text, ',');
    if (field[0] == name && field[1] == pairing) return std::stod(field[4]);
  }
  return 0;
}

}  // namespace

PairedInstance load_instance(const std::filesystem::path& folder, const std::string& name,
                             const std::string& pairing) {
  const std::filesystem::path tsp = folder / (name + ".tsp");
  if (!std::filesystem::exists(tsp)) return {};
  return {read_paired_cities(tsp, folder / (name + "." + pairing + ".pairs")).arcs,
          read_best_tour_m(folder / "arc_reference.csv", name, pairing)};
}

}  // namespace arcbid
