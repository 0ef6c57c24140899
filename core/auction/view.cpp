// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/view.hpp"

#include <algorithm>
#include <utility>

#include "core/auction/bundle.hpp"
#include "core/auction/roster.hpp"
#include "core/base/digest.hpp"
#include "core/base/error.hpp"

namespace arcbid {
namespace {

void add(Digest& d, const Claims& claims) {
  for (const Claim& claim : claims.bundle) d.add(std::uint64_t{claim.task.value}).add(claim.bid);
}

void add(Digest& d, const Table& table) {
  for (const Belief& belief : table.beliefs)
    d.add(std::uint64_t{belief.winner ? belief.winner->value + 1ULL : 0ULL}).add(belief.bid);
  for (const std::uint64_t timestamp : table.timestamps) d.add(timestamp);
}

std::uint64_t digest_of(const Statement& statement) {
  Digest d;
  d.add(statement.key.incarnation).add(std::uint64_t{statement.key.dead});
  d.add(std::uint64_t{statement.key.version});
  std::visit([&d](const auto& body) { add(d, body); }, statement.body);
  return d.value();
}

}  // namespace

View::View(std::vector<AgentId> roster) : roster_(std::move(roster)) {
  check(std::is_sorted(roster_.begin(), roster_.end()), "the roster is sorted");
  for (const AgentId agent : roster_) statements_.push_back({agent, {}, Claims{}});
  for (const Statement& statement : statements_) contents_.push_back(digest_of(statement));
}

bool View::merge(Statement statement) {
  const auto at = position(statement.agent);
  check(at.has_value(), "a merged statement's agent is of the roster");
  if (statement.key <= statements_[*at].key) return false;
  contents_[*at] = digest_of(statement);
  statements_[*at] = std::move(statement);
  return true;
}

std::optional<std::size_t> View::position(AgentId agent) const {
  return position_in(roster_, agent);
}

bool View::heard(std::size_t position) const {
  return statements_[position].key != StatementKey{};
}

bool View::dead(AgentId agent) const {
  const auto at = position(agent);
  return at && dead(*at);
}

std::vector<StatementKey> View::keys() const {
  std::vector<StatementKey> keys;
  for (const Statement& statement : statements_) keys.push_back(statement.key);
  return keys;
}

std::uint64_t View::hash() const {
  Digest d;
  for (const std::uint64_t content : contents_) d.add(content);
  return d.value();
}

std::vector<Belief> best_claims(const View& view, std::size_t tasks,
                                std::optional<AgentId> without) {
  std::vector<Belief> best(tasks);
  for (std::size_t k = 0; k < view.roster().size(); ++k) {
    const AgentId agent = view.roster()[k];
    const auto* claims = std::get_if<Claims>(&view.of(k).body);
    if (view.dead(k) || agent == without || !claims) continue;
    for (const Claim& claim : claims->bundle)
      if (beats(claim.bid, agent, best[claim.task.value]))
        best[claim.task.value] = {agent, claim.bid};
  }
  return best;
}

}  // namespace arcbid
