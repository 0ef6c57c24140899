// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/checker/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/checker/geometry.hpp"

namespace arcbid::checker {

namespace {

void sort_by_start(std::vector<Stretch>& stretches) {
  std::ranges::stable_sort(stretches, {}, &Stretch::from_m);
}

/// Sums what is wrong along an arc and remembers the first place worth naming.
class Fault {
 public:
  void add(double from_m, double to_m, const std::string& whose) {
    sum_m_ += to_m - from_m;
    if (to_m - from_m <= longest_m_) return;
    longest_m_ = to_m - from_m;
    where_ = fmt::format("from {:.4f} to {:.4f} m{}", from_m, to_m, whose);
  }
  bool matters() const { return sum_m_ > kTolerance_m; }
  std::string line(const char* what) const {
    return fmt::format("{:.4f} m {}, the longest part {}", sum_m_, what, where_);
  }

 private:
  double sum_m_ = 0, longest_m_ = 0;
  std::string where_;
};

/// Merges what touches or overlaps.
std::vector<Stretch> merged(std::vector<Stretch> stretches) {
  sort_by_start(stretches);
  std::vector<Stretch> result;
  for (const Stretch& s : stretches) {
    if (!result.empty() && s.from_m <= result.back().to_m)
      result.back().to_m = std::max(result.back().to_m, s.to_m);
    else
      result.push_back(s);
  }
  return result;
}

double total_m(const std::vector<Stretch>& disjoint) {
  double sum = 0;
  for (const Stretch& s : disjoint) sum += s.to_m - s.from_m;
  return sum;
}

}  // namespace

std::vector<std::string> why_not_tiled(std::vector<Stretch> stretches, double length_m) {
  sort_by_start(stretches);
  Fault missing, repeated, outside;
  double covered_m = 0;
  const Stretch* reaching = nullptr;  // the one that covers up to covered_m
  for (const Stretch& s : stretches) {
    if (s.from_m < 0) outside.add(s.from_m, std::min(0.0, s.to_m), " by " + s.whose);
    if (s.to_m > length_m) outside.add(std::max(length_m, s.from_m), s.to_m, " by " + s.whose);
    const double from_m = std::clamp(s.from_m, 0.0, length_m);
    const double to_m = std::clamp(s.to_m, 0.0, length_m);
    if (from_m > covered_m) missing.add(covered_m, from_m, " before " + s.whose);
    if (from_m < covered_m && reaching != nullptr)
      repeated.add(from_m, std::min(covered_m, to_m),
                   fmt::format(" by {} and {}", reaching->whose, s.whose));
    if (to_m > covered_m || reaching == nullptr) reaching = &s;
    covered_m = std::max(covered_m, to_m);
  }
  if (covered_m < length_m) missing.add(covered_m, length_m, "");
  std::vector<std::string> lines;
  if (missing.matters()) lines.push_back(missing.line("not covered"));
  if (repeated.matters()) lines.push_back(repeated.line("covered twice"));
  if (outside.matters()) lines.push_back(outside.line("outside the arc"));
  return lines;
}

double difference_m(std::vector<Stretch> a, std::vector<Stretch> b) {
  std::vector<Stretch> either = a;
  either.insert(either.end(), b.begin(), b.end());
  // |A xor B| = (|A or B| - |A|) + (|A or B| - |B|)
  return 2 * total_m(merged(std::move(either))) - total_m(merged(std::move(a))) -
         total_m(merged(std::move(b)));
}

}  // namespace arcbid::checker
