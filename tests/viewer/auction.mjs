// SPDX-License-Identifier: GPL-3.0-or-later
// A small auction by claims, in rounds, on links that lose: enough to be consistent with itself.
import { distance, vertex } from './bridge.mjs';

const NOBODY = -1;

function greedyBundle(agent, tasks, rivals, capacity) {
  const mine = [];
  const left = new Set(tasks.map((_, i) => i));
  let load = 0, last = Infinity;
  while (mine.length < capacity) {
    let best = -1, bestBid = -Infinity;
    for (const i of left) {
      const bid = Math.min(last, -(load + tasks[i].metres + 2 * distance(agent.home, tasks[i].middle)));
      const rival = rivals[i];
      const wins = !rival || bid > rival.bid || (bid === rival.bid && agent.agent < rival.agent);
      if (wins && bid > bestBid) { best = i; bestBid = bid; }
    }
    if (best < 0) break;
    left.delete(best);
    load += tasks[best].metres;
    last = bestBid;
    mine.push([best, bestBid]);
  }
  return mine;
}

/** The best claim on each piece, of all statements held but those of the dead. */
function bestClaims(statements, without) {
  const best = [];
  for (const [agent, { bundle }] of [...statements].sort((a, b) => a[0] - b[0])) {
    if (without.has(agent)) continue;
    for (const [i, bid] of bundle) if (!best[i] || bid > best[i].bid) best[i] = { agent, bid };
  }
  return best;
}

class Bidder {
  constructor(agent, tasks, capacity) {
    Object.assign(this, { agent, tasks, capacity, round: 0, statements: new Map(), buried: new Set() });
    this.table = tasks.map(() => ({ winner: NOBODY, bid: null }));
    this.changes = [];
  }
  get id() { return this.agent.agent; }
  get own() { return this.statements.get(this.id); }

  decide(t, record) {
    this.round++;
    const before = this.own?.bundle ?? [];
    const rivals = bestClaims(this.statements, new Set([...this.buried, this.id]));
    const bundle = greedyBundle(this.agent, this.tasks, rivals, this.capacity);
    const changed = JSON.stringify(bundle) !== JSON.stringify(before) || !this.own;
    if (changed) this.statements.set(this.id, { version: (this.own?.version ?? 0) + 1, bundle });
    record.decisions.push({ t_s: t, agent: this.id, round: this.round, changed, bundle: bundle.flatMap(([i, bid]) => [this.tasks[i].task, bid]) });
    const held = new Set(before.map(([i]) => i));
    for (const [i, bid] of bundle) if (!held.has(i)) this.explain(t, i, bid, rivals[i], record);
    this.note(t);
    return changed;
  }
  explain(t, i, bid, rival, record) {
    const why = rival ? `outbids agent ${rival.agent}'s ${rival.bid.toFixed(1)} by ${(bid - rival.bid).toFixed(1)}` : 'nobody else has bid yet';
    (record.explanations[this.tasks[i].task] ??= []).push({ t_s: t, agent: this.id, text: `agent ${this.id} bids ${bid.toFixed(1)}: ${why}` });
  }
  note(t) {
    const best = bestClaims(this.statements, this.buried);
    const z = [];
    this.table.forEach((entry, i) => {
      const winner = best[i]?.agent ?? NOBODY, bid = best[i]?.bid ?? null;
      if (entry.winner === winner && entry.bid === bid) return;
      Object.assign(entry, { winner, bid });
      z.push(this.tasks[i].task, winner, bid);
    });
    if (z.length > 0) this.changes.push({ t_s: t, round: this.round, z });
  }
  hear(from, statement) {
    if ((this.statements.get(from)?.version ?? 0) < statement.version) { this.statements.set(from, statement); return true; }
    return false;
  }
}

const round6 = (value) => Math.round(value * 1e6) / 1e6;

function exchange(bidders, living, t, plan, random, record) {
  const bin = Math.floor(t / record.bin_s);
  const news = [];
  for (const from of living) for (const to of living) {
    if (from === to) continue;
    const split = t >= plan.partition[0] && t < plan.partition[1] && (from.id % 2) !== (to.id % 2);
    const lost = split || random() < plan.loss;
    const key = `${bin} ${from.id} ${to.id}`;
    const row = record.links.get(key) ?? [bin, from.id, to.id, 0, 0, 0, 0];
    row[3]++;
    if (lost) row[4]++; else if (random() < 0.03) row[5]++;
    record.links.set(key, row);
    if (!lost) for (const [who, statement] of from.statements) news.push([to, who, statement]);
  }
  const heard = new Set();
  for (const [to, who, statement] of news) if (to.hear(who, statement)) heard.add(to);
  return heard;
}

/** Bids in rounds of 20 ms until nothing changes any more and every fault of `plan` is over. */
export function auction(agents, tasks, plan, random) {
  const record = { decisions: [], explanations: {}, links: new Map(), bin_s: 0.05, states: [], events: [] };
  const capacity = Math.ceil((2.5 * tasks.length) / agents.length);
  const measured = tasks.map((task) => ({ ...task, metres: task.to_m - task.from_m, middle: vertex(task.line, Math.floor(task.line.length / 6)) }));
  const bidders = agents.map((agent) => new Bidder(agent, measured, capacity));
  const event = (t_s, kind, agent, text) => record.events.push({ t_s, kind, agent, text });
  const state = (t_s, who, name) => record.states.push({ t_s, agent: who, state: name });
  for (const { id } of bidders) state(round6(0.3 + 0.01 * random()), id, 'waiting');
  event(0.58, 'mission', null, `mission published: ${tasks.length} pieces`);
  event(plan.start, 'start', null, 'everybody is here: bidding');
  for (const { id } of bidders) state(plan.start, id, 'bidding');
  event(plan.partition[0], 'partition', null, 'odd and even agents no longer hear each other');
  event(plan.partition[1], 'heal', null, 'the fleet is whole again');
  event(plan.death.t, 'death', plan.death.agent, `agent ${plan.death.agent} killed`);
  state(plan.death.t, plan.death.agent, 'dead');
  let dirty = new Set(bidders), agreed = false, t = plan.start;
  for (let k = 0; ; k++) {
    t = round6(plan.start + 0.02 * k);
    const living = bidders.filter(({ id }) => t < plan.death.t || id !== plan.death.agent);
    if (t >= plan.death.t + 0.06)
      for (const one of living) if (!one.buried.has(plan.death.agent)) {
        one.buried.add(plan.death.agent);
        dirty.add(one);
        if (agreed) event(t, 'reopened', one.id, `agent ${one.id} misses agent ${plan.death.agent}`);
        state(t, one.id, 'bidding');
      }
    let changed = false;
    for (const one of living) if (dirty.has(one)) changed = one.decide(round6(t + 0.004 * random()), record) || changed;
    const healed = t >= plan.partition[1];
    dirty = exchange(bidders, living, round6(t + 0.006), plan, random, record);
    for (const one of dirty) one.note(round6(t + 0.008));
    const still = !changed && dirty.size === 0 && healed && living.every((one) => JSON.stringify(one.table) === JSON.stringify(living[0].table));
    if (still && !agreed) {
      event(round6(t + 0.01), 'agreement', null, `agreement proven by all ${living.length}`);
      for (const { id } of living) state(round6(t + 0.01), id, 'agreed');
    }
    agreed = still;
    if (agreed && t > plan.death.t + 0.06) {
      for (const { id } of living) { state(round6(t + 0.02), id, 'routed'); event(round6(t + 0.02), 'route', id, `agent ${id} published its route`); }
      return { record, bidders, living, end_s: round6(t + 0.05), agreed_s: round6(t + 0.01) };
    }
  }
}
