// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/auction/instance.hpp"

#include <fmt/format.h>

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include <charconv>
#include <cmath>
#include <string>

#include "core/base/digest.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

constexpr std::size_t most_agents = 1000, most_tasks = 100000;

/// A row of numbers with a number of its own in front.
struct Row {
  double x_m, y_m, z_m, last;
};

/// One file of rows numbered 0, 1, 2 …
class Rows {
 public:
  Rows(const std::filesystem::path& file, const char* number, const std::string& last)
      : file_(file.string()), number_(number), last_(last) {}

  std::vector<Row> read(std::size_t most) const try {
    io::CSVReader<5> csv(file_);
    csv.read_header(io::ignore_extra_column, std::string(number_), "x", "y", "z", last_);
    std::vector<Row> rows;
    std::string number, x, y, z, last;
    while (csv.read_row(number, x, y, z, last)) {
      const auto line = csv.get_file_line();
      if (number != std::to_string(rows.size()))
        throw InputError(fmt::format("{}:{}: {}: '{}' is not {}, the next number", file_, line,
                                     number_, number, rows.size()));
      rows.push_back({value(line, "x", x), value(line, "y", y), value(line, "z", z),
                      value(line, last_, last)});
      if (rows.size() > most)
        throw InputError(fmt::format("{}:{}: more than {} rows", file_, line, most));
    }
    if (rows.empty()) throw InputError(fmt::format("{}: no rows below the header", file_));
    return rows;
  } catch (const io::error::base& error) {
    throw InputError(fmt::format("{}: {}", file_, error.what()));
  }

 private:
  double value(unsigned line, const std::string& column, const std::string& text) const {
    double out = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, out);
    if (error != std::errc() || stop != end || !std::isfinite(out))
      throw InputError(
          fmt::format("{}:{}: {}: '{}' is not a finite number", file_, line, column, text));
    return out;
  }

  std::string file_;
  const char* number_;
  std::string last_;
};

}  // namespace

Instance read_instance(const std::filesystem::path& agents, const std::filesystem::path& tasks,
                       const std::string& value_column) {
  Instance instance;
  std::uint32_t id = 0;
  for (const Row& row : Rows(agents, "agent", "speed").read(most_agents)) {
    if (row.last <= 0)
      throw InputError(
          fmt::format("{}: speed of agent {}: {} is not above 0", agents.string(), id, row.last));
    instance.fleet.push_back({{++id}, Vec3(row.x_m, row.y_m, row.z_m), row.last});
  }
  TaskSet& set = instance.tasks;
  set.return_home = false;
  Digest digest;
  for (const Row& row : Rows(tasks, "task", value_column).read(most_tasks)) {
    const Vec3 at_m(row.x_m, row.y_m, row.z_m);
    const auto j = static_cast<std::uint32_t>(set.tasks.size());
    set.tasks.push_back(
        {.id = {j}, .arc = {j}, .first_m = at_m, .last_m = at_m, .value = row.last});
    digest.add(row.x_m).add(row.y_m).add(row.z_m).add(row.last);
  }
  set.digest = digest.value();
  return instance;
}

}  // namespace arcbid
