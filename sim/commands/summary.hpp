// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/world/batch.hpp"

namespace arcbid {

/// What many worlds came to.
class SimSummary {
 public:
  void add(const PricedResult& result);

  std::uint64_t worlds() const { return worlds_; }
  std::uint64_t violations() const { return violations_; }

  nlohmann::json to_json(double wall_s) const;
  std::string table(double wall_s) const;

 private:
  /// Of one figure over all worlds.
  struct Figure {
    std::vector<double> values;
    double mean() const;
    double at(double share) const;  ///< the value that this share of worlds does not exceed
  };
  static nlohmann::json to_json(const Figure& figure);

  std::uint64_t worlds_ = 0, violations_ = 0, disagreed_ = 0, refused_ = 0, steps_ = 0;
  Figure rounds_, messages_, kilobytes_, agreement_s_, after_calm_s_, of_bound_, of_steps_,
      makespan_s_;
  Figure price_rounds_, price_messages_, price_makespan_;  // with faults, by without
};

}  // namespace arcbid
