// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/bundle.hpp"

#include <algorithm>

namespace arcbid {
namespace {

/// Whether somebody else among the living claims the task at a bid that wins against `own`.
bool is_outbid(const View& view, AgentId self, const Claim& own) {
  for (std::size_t k = 0; k < view.roster().size(); ++k) {
    const Statement& said = view.of(k);
    const auto* claims = std::get_if<Claims>(&said.body);
    if (said.agent == self || said.key.dead || !claims) continue;
    for (const Claim& rival : claims->bundle)
      if (rival.task == own.task &&
          (rival.bid > own.bid || (rival.bid == own.bid && said.agent < self)))
        return true;
  }
  return false;
}

}  // namespace

BundleChecker::BundleChecker(const Mission& mission, Findings& findings)
    : policy_(mission.auction.policy),
      warped_(mission.auction.score != ScoreKind::discounted_insert),
      limit_(mission.auction.bundle_limit),
      findings_(findings) {}

void BundleChecker::after(const SeenStep& step) {
  if (!step.update.decision) return;
  std::vector<std::uint32_t> held;
  const StatementBody& body = step.update.decision->body;
  if (const auto* claims = std::get_if<Claims>(&body)) {
    for (const Claim& claim : claims->bundle) held.push_back(claim.task.value);
    check_bids(step, claims->bundle);
    std::vector<Claim>& before = bundles_[step.life];
    // What is stated at the start was decided before anybody was heard.
    const bool on_the_view = !step.update.started;
    if (policy_ == PolicyKind::claims_keep && on_the_view)
      check_cascade(step, before, claims->bundle);
    before = claims->bundle;
  } else if (const auto* table = std::get_if<Table>(&body)) {
    for (std::uint32_t j = 0; j < table->beliefs.size(); ++j)
      if (table->beliefs[j].winner == step.agent) held.push_back(j);
  }
  check_path(step, std::move(held));
}

void BundleChecker::check_path(const SeenStep& step, std::vector<std::uint32_t> held) const {
  std::vector<std::uint32_t> flown;
  for (const PathStop& stop : step.update.decision->path) flown.push_back(stop.task.value);
  std::sort(held.begin(), held.end());
  std::sort(flown.begin(), flown.end());
  if (held != flown)
    findings_.add(step.now_ns, "bundle", "agent {} holds [{}] and flies [{}]", step.agent.value,
                  fmt::join(held, " "), fmt::join(flown, " "));
  if (std::adjacent_find(held.begin(), held.end()) != held.end())
    findings_.add(step.now_ns, "bundle", "agent {} holds a task twice", step.agent.value);
  if (limit_ > 0 && held.size() > limit_)
    findings_.add(step.now_ns, "bundle", "agent {} holds {} tasks, more than {}", step.agent.value,
                  held.size(), limit_);
}

void BundleChecker::check_bids(const SeenStep& step, const std::vector<Claim>& bundle) const {
  for (std::size_t n = 1; warped_ && n < bundle.size(); ++n)
    if (bundle[n].bid > bundle[n - 1].bid)
      findings_.add(step.now_ns, "bundle", "agent {} bids {} for task {}, more than {} before",
                    step.agent.value, bundle[n].bid, bundle[n].task.value, bundle[n - 1].bid);
}

void BundleChecker::check_cascade(const SeenStep& step, const std::vector<Claim>& before,
                                  const std::vector<Claim>& after) const {
  std::size_t kept = 0;
  while (kept < before.size() && !is_outbid(step.view, step.agent, before[kept])) ++kept;
  const bool stays =
      after.size() >= kept &&
      std::equal(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(kept), after.begin());
  if (!stays)
    findings_.add(step.now_ns, "cascade", "agent {} gives up tasks that nobody outbid it on",
                  step.agent.value);
  for (const Claim& claim : after)
    if (is_outbid(step.view, step.agent, claim))
      findings_.add(step.now_ns, "cascade", "agent {} holds task {}, on which it is outbid",
                    step.agent.value, claim.task.value);
}

}  // namespace arcbid
