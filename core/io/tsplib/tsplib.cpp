// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/tsplib/tsplib.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/io/readers/text.hpp"

namespace arcbid {
namespace {

using Words = std::vector<std::string_view>;
using Cities = std::map<std::uint32_t, Vec3>;

/// A text file, line by line, that says where in it something is wrong.
class Text {
 public:
  explicit Text(const std::filesystem::path& file) : name_(file.string()) {
    if (std::filesystem::is_directory(file)) throw InputError(name_ + ": is a directory");
    std::ifstream in(file, std::ios::binary);
    text_.assign(std::istreambuf_iterator<char>(in), {});
    if (!in.is_open() || in.bad()) throw InputError(name_ + ": cannot be read");
    lines_.emplace(text_);
  }
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  /// The words of the next line that has any.
  bool next(Words& words) {
    while (const auto line = lines_->next()) {
      words = readers::words(*line, ":");
      if (!words.empty()) return true;
    }
    return false;
  }
  [[noreturn]] void fail_here(const std::string& why) const {
    throw InputError(fmt::format("{}:{}: {}", name_, lines_->number(), why));
  }
  [[noreturn]] void fail(const std::string& why) const { throw InputError(name_ + ": " + why); }

  std::uint32_t city(std::string_view word) const {
    const auto number = readers::to_integer(word);
    if (!number || *number < 1 || *number > UINT32_MAX)
      fail_here(fmt::format("'{}' is no city; legal: a number from 1", word));
    return static_cast<std::uint32_t>(*number);
  }
  double coordinate(std::string_view word) const {
    const auto number = readers::to_number(word);
    if (!number || !std::isfinite(*number))
      fail_here(fmt::format("'{}' is no coordinate; legal: a finite number", word));
    return *number;
  }

 private:
  std::string name_, text_;
  std::optional<readers::Lines> lines_;
};

Cities read_section(Text& in) {
  Cities cities;
  for (Words words; in.next(words) && words[0] != "EOF";) {
    if (words[0].ends_with("_SECTION")) break;
    if (words.size() != 3 && words.size() != 4)
      in.fail_here(
          fmt::format("{} words; legal: a city and two or three coordinates", words.size()));
    const double z = words.size() == 4 ? in.coordinate(words[3]) : 0;
    const Vec3 at(in.coordinate(words[1]), in.coordinate(words[2]), z);
    if (!cities.emplace(in.city(words[0]), at).second)
      in.fail_here(fmt::format("city {} is there twice", words[0]));
  }
  return cities;
}

Cities numbered_cities(const std::filesystem::path& file) {
  Text in(file);
  std::optional<std::int64_t> dimension;
  for (Words words; in.next(words);) {
    if (words[0] == "DIMENSION" && words.size() == 2) dimension = readers::to_integer(words[1]);
    if (words[0] != "NODE_COORD_SECTION") continue;
    Cities cities = read_section(in);
    if (dimension && *dimension != static_cast<std::int64_t>(cities.size()))
      in.fail(fmt::format("DIMENSION is {}, but {} cities follow", *dimension, cities.size()));
    if (cities.empty()) in.fail("no city in its NODE_COORD_SECTION");
    return cities;
  }
  in.fail("no NODE_COORD_SECTION; legal: TSPLIB instances given by coordinates");
}

const Vec3& place(const Text& in, const Cities& cities, std::uint32_t city) {
  const auto found = cities.find(city);
  if (found == cities.end())
    in.fail_here(fmt::format("there is no city {}; legal: {} to {}", city, cities.begin()->first,
                             cities.rbegin()->first));
  return found->second;
}

/// "# node N is a duplicate of node K"
bool is_duplicate(const Words& words) {
  return words.size() >= 9 && words[0] == "#" && words[1] == "node" && words[5] == "duplicate";
}

void add_duplicate(const Text& in, Cities& cities, const Words& words) {
  const Vec3 at = place(in, cities, in.city(words[8]));
  if (!cities.emplace(in.city(words[2]), at).second)
    in.fail_here(fmt::format("city {} is there already", words[2]));
}

}  // namespace

std::vector<Vec3> read_cities(const std::filesystem::path& tsp) {
  std::vector<Vec3> cities;
  for (const auto& [number, at] : numbered_cities(tsp)) cities.push_back(at);
  return cities;
}

PairedCities read_paired_cities(const std::filesystem::path& tsp,
                                const std::filesystem::path& pairs) {
  Cities cities = numbered_cities(tsp);
  Text in(pairs);
  PairedCities out;
  std::map<std::uint32_t, bool> is_paired;
  for (Words words; in.next(words);) {
    if (is_duplicate(words)) add_duplicate(in, cities, words);
    if (words[0].starts_with("#")) continue;
    if (words.size() != 2)
      in.fail_here(fmt::format("{} words; legal: the two cities of a pair", words.size()));
    const std::uint32_t first = in.city(words[0]), last = in.city(words[1]);
    const Vec3 from = place(in, cities, first), to = place(in, cities, last);
    for (const std::uint32_t city : {first, last})
      if (std::exchange(is_paired[city], true))
        in.fail_here(fmt::format("city {} is in a pair already; legal: each in one", city));
    out.arcs.push_back({from, to, (to - from).norm()});
    out.pairs.push_back({first, last});
  }
  for (const auto& [city, at] : cities)
    if (!is_paired[city]) in.fail(fmt::format("city {} is in no pair; legal: each in one", city));
  return out;
}

}  // namespace arcbid
