// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/world/checkers/checkers.hpp"
#include "sim/world/checkers/greedy.hpp"

namespace arcbid::testing {

/// Two agents at the ends of a line, three arcs of one piece each.
inline Mission small_mission() {
  Mission mission;
  mission.fleet = {{{1}, Vec3(0, 0, 0), 1}, {{2}, Vec3(100, 0, 0), 1}};
  for (std::uint32_t m = 0; m < 3; ++m) {
    const double x_m = 20 + 30 * m;
    mission.arcs.push_back(
        {{m},
         ArcKind::outline,
         {{Vec3(x_m, 0, 0), Vec3::UnitZ()}, {Vec3(x_m + 5, 0, 0), Vec3::UnitZ()}}});
  }
  mission.auction.split_m = 5;
  return mission;
}

class CheckerTest : public ::testing::Test {
 protected:
  bool finds(const std::string& checker) const {
    for (const Violation& v : checkers.findings.found())
      if (v.checker == checker) return true;
    return false;
  }
  bool finds_nothing() const { return checkers.findings.found().empty(); }

  /// Agent `id` decides on `bundle`, flown in that order.
  void decides(std::uint32_t id, std::uint32_t version, const std::vector<Claim>& bundle) {
    Update update;
    update.decision = DecisionMade{version, true, {7, false, version}, Claims{bundle}, {}};
    for (const Claim& claim : bundle) update.decision->path.push_back({claim.task, false});
    view.merge({{id}, {7, false, version}, Claims{bundle}});
    decides(id, update);
  }
  void decides(std::uint32_t id, const Update& update) {
    const std::vector<Belief> winners = best_claims(view, 3);
    checkers.after({now_ns++, {id}, id, update, view, &winners});
  }
  Agreement agreement(std::uint32_t id, const std::vector<TaskId>& path) const {
    Agreement proof{77, 1, {{1}, {2}}, best_claims(view, 3), {}, {}, {}};
    for (const TaskId task : path) proof.path.push_back({task, false});
    return id > 0 ? proof : Agreement{};
  }
  void proves(std::uint32_t id, const Agreement& proof) {
    Update update;
    update.agreed = proof;
    checkers.after({now_ns++, {id}, id, update, view, nullptr});
  }

  Mission mission = small_mission();
  const std::vector<Stretch> pieces = cut(mission);
  const StraightTransit transit;
  Checkers checkers{mission, pieces, transit};
  View view{{{1}, {2}}};
  TimeNs now_ns = 1;
  const Claim a{{0}, -50}, b{{1}, -110}, c{{2}, -50};
};

class OutcomeTest : public ::testing::Test {
 protected:
  std::vector<std::string> greedy(const std::vector<Bidder>& bidders) const {
    Findings findings;
    check_greedy(mission, cut(mission), bidders, StraightTransit(), 0, findings);
    std::vector<std::string> out;
    for (const Violation& v : findings.found()) out.push_back(v.what);
    return out;
  }
  Mission mission = small_mission();
};

}  // namespace arcbid::testing
