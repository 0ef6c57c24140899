// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/checkers/proof.hpp"

#include <algorithm>

namespace arcbid {
namespace {

bool contains(const std::vector<AgentId>& agents, AgentId agent) {
  return std::find(agents.begin(), agents.end(), agent) != agents.end();
}

/// Whether `said` gives task `j` to `owner` at `bid`; in a table also whether nobody owns it.
bool says(const Statement& said, std::size_t j, const Belief& belief) {
  if (const auto* table = std::get_if<Table>(&said.body))
    return j < table->beliefs.size() && table->beliefs[j] == belief;
  const auto& bundle = std::get<Claims>(said.body).bundle;
  return std::any_of(bundle.begin(), bundle.end(), [&](const Claim& claim) {
    return claim.task.value == j && claim.bid == belief.bid;
  });
}

}  // namespace

ProofChecker::ProofChecker(const Mission& mission, std::size_t tasks, Findings& findings)
    : tasks_(tasks), limit_(mission.auction.bundle_limit), findings_(findings) {}

void ProofChecker::after(const SeenStep& step) {
  if (!step.update.agreed) return;
  const Agreement& proof = *step.update.agreed;
  check_members(step, proof);
  check_owners(step, proof);
  check_path(step, proof);
  check_statements(step, proof);
  const auto [at, is_first] =
      proven_.try_emplace(proof.view_hash, Proven{proof.members, proof.winners, proof.left});
  const Proven& first = at->second;
  const bool same =
      first.members == proof.members && first.winners == proof.winners && first.left == proof.left;
  if (!is_first && !same)
    findings_.add(step.now_ns, "proof", "agent {} proves {:016x} with another outcome",
                  step.agent.value, proof.view_hash);
}

void ProofChecker::check_members(const SeenStep& step, const Agreement& proof) const {
  std::vector<AgentId> living;
  for (std::size_t k = 0; k < step.view.roster().size(); ++k)
    if (!step.view.of(k).key.dead) living.push_back(step.view.of(k).agent);
  if (living != proof.members || !contains(living, step.agent))
    findings_.add(step.now_ns, "proof", "agent {} proves for others than the living of its view",
                  step.agent.value);
}

void ProofChecker::check_owners(const SeenStep& step, const Agreement& proof) const {
  if (proof.winners.size() != tasks_)
    findings_.add(step.now_ns, "proof", "agent {} proves {} tasks, not {}", step.agent.value,
                  proof.winners.size(), tasks_);
  std::map<AgentId, std::size_t> loads;
  for (std::size_t j = 0; j < proof.winners.size(); ++j) {
    const Belief& belief = proof.winners[j];
    if (!belief.winner) continue;
    ++loads[*belief.winner];
    if (!contains(proof.members, *belief.winner))
      findings_.add(step.now_ns, "proof", "task {} is won by agent {}, who is no member", j,
                    belief.winner->value);
  }
  for (const AgentId member : proof.members) {
    if (limit_ > 0 && loads[member] > limit_)
      findings_.add(step.now_ns, "proof", "agent {} wins more than {} tasks", member.value, limit_);
  }
}

void ProofChecker::check_path(const SeenStep& step, const Agreement& proof) const {
  std::vector<std::size_t> flown, won;
  for (const PathStop& stop : proof.path) flown.push_back(stop.task.value);
  for (std::size_t j = 0; j < proof.winners.size(); ++j)
    if (proof.winners[j].winner == step.agent) won.push_back(j);
  std::sort(flown.begin(), flown.end());
  if (flown != won)
    findings_.add(step.now_ns, "proof", "agent {} flies [{}] and has won [{}]", step.agent.value,
                  fmt::join(flown, " "), fmt::join(won, " "));
}

/// The newest statement of every owner gives it its tasks, to nobody's surprise; tables of all
/// living members are equal. Claims of others may stand: they are outbid.
void ProofChecker::check_statements(const SeenStep& step, const Agreement& proof) const {
  for (std::size_t k = 0; k < step.view.roster().size(); ++k) {
    const Statement& said = step.view.of(k);
    if (said.key.dead) continue;
    const bool is_table = std::holds_alternative<Table>(said.body);
    for (std::size_t j = 0; j < proof.winners.size(); ++j)
      if ((is_table || proof.winners[j].winner == said.agent) && !says(said, j, proof.winners[j]))
        findings_.add(step.now_ns, "proof",
                      "agent {} has not stated what agent {} proves of task {}", said.agent.value,
                      step.agent.value, j);
    const auto* claims = std::get_if<Claims>(&said.body);
    for (const Claim& claim : claims ? claims->bundle : std::vector<Claim>{})
      if (proof.winners.at(claim.task.value).winner != said.agent)
        findings_.add(step.now_ns, "proof", "agents {} and {} both claim task {} in a proven view",
                      said.agent.value, proof.winners[claim.task.value].winner->value,
                      claim.task.value);
  }
}

void StabilityChecker::after(const SeenStep& step) {
  const bool news = step.update.decision && step.update.decision->changed;
  if (!news && !step.update.agreed) return;
  Keys keys;
  std::vector<bool> members;
  std::size_t position = 0;
  for (std::size_t k = 0; k < step.view.roster().size(); ++k) {
    keys.push_back(step.view.of(k).key);
    members.push_back(!keys.back().dead);
    if (step.view.of(k).agent == step.agent) position = k;
  }
  if (news) {
    news_.push_back({step.now_ns, step.agent, position, keys});
    for (const Proven& proven : proven_) blame(proven, news_.back());
  }
  if (!step.update.agreed) return;
  const std::uint64_t hash = step.update.agreed->view_hash;
  const auto known = [hash](const Proven& proven) { return proven.hash == hash; };
  if (std::any_of(proven_.begin(), proven_.end(), known)) return;
  proven_.push_back({hash, std::move(members), std::move(keys)});
  for (const News& earlier : news_) blame(proven_.back(), earlier);
}

void StabilityChecker::blame(const Proven& proven, const News& news) {
  if (!proven.members[news.position]) return;
  if (std::find(twins_.begin(), twins_.end(), news.agent) != twins_.end()) return;
  const StatementKey &then = proven.keys[news.position], &now = news.keys[news.position];
  if (now.incarnation != then.incarnation || now <= then) return;
  for (std::size_t k = 0; k < news.keys.size(); ++k)
    if (k != news.position && news.keys[k] > proven.keys[k]) return;
  findings_.add(news.now_ns, "stability",
                "agent {} changes its mind for no reason after it was ready for {:016x}",
                news.agent.value, proven.hash);
}

}  // namespace arcbid
