// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tour/tsplib.hpp"

#include <array>
#include <fstream>
#include <map>
#include <sstream>

namespace arcbid {

namespace {

std::map<int, Vec3> read_cities(const std::filesystem::path& file) {
  std::map<int, Vec3> cities;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && !line.starts_with("NODE_COORD_SECTION")) continue;
  int city = 0;
  for (double x = 0, y = 0; in >> city >> x >> y;) cities[city] = Vec3(x, y, 0);
  return cities;
}

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
  PairedInstance instance;
  std::map<int, Vec3> cities = read_cities(folder / (name + ".tsp"));
  std::ifstream in(folder / (name + "." + pairing + ".pairs"));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string hash, node, is, a, duplicate, of;
    int i = 0, j = 0;
    if (line.starts_with("# node")) {  // # node N is a duplicate of node K
      words >> hash >> node >> i >> is >> a >> duplicate >> of >> node >> j;
      cities[i] = cities.at(j);
    } else if (words >> i >> j) {
      const Vec3 first = cities.at(i), last = cities.at(j);
      instance.arcs.push_back({first, last, (last - first).norm()});
    }
  }
  instance.best_tour_m = read_best_tour_m(folder / "arc_reference.csv", name, pairing);
  return instance;
}

}  // namespace arcbid
