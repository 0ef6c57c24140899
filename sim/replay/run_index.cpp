// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/run_index.hpp"

#include <future>
#include <thread>

namespace arcbid {

RunIndex::RunIndex(const RunArchive& run) {
  const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t from = 0; from < run.lives.size(); from += at_once) {
    std::vector<std::future<Life>> some;
    for (std::size_t l = from; l < std::min(run.lives.size(), from + at_once); ++l)
      some.push_back(std::async(std::launch::async, [&run, l] { return read(run.lives[l]); }));
    for (auto& one : some) {
      lives_.push_back(one.get());
      bodies_.merge(lives_.back().bodies);
      lives_.back().bodies.clear();
    }
  }
}

const StatementBody* RunIndex::body(AgentId agent, const StatementKey& key) const {
  const auto found = bodies_.find({agent, key});
  return found == bodies_.end() || key.dead ? nullptr : &found->second;
}

RunIndex::Life RunIndex::read(const LifeLog& log) {
  Life life;
  const std::vector<Mark>& marks = log.marks();
  for (std::size_t m = 0; m < marks.size(); ++m)
    if (marks[m].changed || marks[m].learnt || marks[m].died || marks[m].returned)
      note(life, m, log.agent(), log.step(m));
  return life;
}

void RunIndex::note(Life& life, std::size_t mark, AgentId self, Step step) {
  const auto keep = [&life](AgentId agent, const StatementKey& key, StatementBody& body) {
    life.bodies.try_emplace({agent, key}, std::move(body));
  };
  Update& update = step.update;
  if (auto& made = update.decision) {
    if (made->changed) life.decisions.push_back({mark, made->round, made->key});
    keep(self, made->key, made->body);
  }
  for (BidMessage& bid : update.bids) keep(self, bid.statement.key, bid.statement.body);
  for (const AgentId agent : update.died) life.notices.push_back({mark, agent, false});
  for (const AgentId agent : update.returned) life.notices.push_back({mark, agent, true});
  if (update.refused) return;
  const auto hear = [&keep](Statement& said) { keep(said.agent, said.key, said.body); };
  if (auto* bid = std::get_if<BidMessage>(&step.event.what)) hear(bid->statement);
  if (auto* relay = std::get_if<RelayMessage>(&step.event.what)) hear(relay->statement);
}

}  // namespace arcbid
