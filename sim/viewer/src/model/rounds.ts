// SPDX-License-Identifier: GPL-3.0-or-later
// What one round brought, and who bids what for one piece.
import { NOBODY } from './beliefs';
import { countUpTo } from './search';
import type { ViewModel } from './view_model';

export interface Claim { owner: number; bid: number }
export interface PieceChange { slot: number; before: Claim; after: Claim }
export interface RoundReport { round: number; from_s: number; deciders: number; changes: PieceChange[] }

/** The newest round at `t`: since its first decision, which pieces changed hands or price. */
export function roundReport(model: ViewModel, t: number): RoundReport {
  const round = model.fleet.roundAt(t);
  const { decisions } = model.data.auction;
  const end = countUpTo(decisions.length, (i) => decisions[i].t_s, t);
  const deciders = new Set<number>();
  let from_s = t;
  for (let i = end - 1; i >= 0; i--) {
    const { agent, round: its, t_s } = decisions[i];
    if (its < round || t_s < model.fleet.bornAt(agent, t)) continue;
    deciders.add(agent);
    from_s = t_s;
  }
  if (deciders.size === 0) return { round, from_s, deciders: 0, changes: [] };
  const before = model.fleet.at(justBefore(from_s));
  const after = model.fleet.at(t);
  const changes: PieceChange[] = [];
  for (let slot = 0; slot < model.tasks.length; slot++)
    if (before.winners[slot] !== after.winners[slot] || !Object.is(before.bids[slot], after.bids[slot]))
      changes.push({
        slot,
        before: { owner: before.winners[slot], bid: before.bids[slot] },
        after: { owner: after.winners[slot], bid: after.bids[slot] },
      });
  // What changed hands comes before what only changed its price.
  const moved = ({ before: held, after: holds }: PieceChange): number => (held.owner === holds.owner ? 1 : 0);
  changes.sort((a, b) => moved(a) - moved(b) || a.slot - b.slot);
  return { round, from_s, deciders: deciders.size, changes };
}

const justBefore = (t: number): number => t - Math.max(Math.abs(t), 1) * 1e-12;

export interface Stance { agent: number; state: string; bid: number; believes: Claim }

/** Each agent's own bid for a piece in its newest bundle (NaN: none), and who it takes for the winner. */
export function stancesOn(model: ViewModel, slot: number, t: number): Stance[] {
  const task = model.tasks[slot].task;
  return model.agents.map((agent) => {
    const bundle = model.fleet.decisionOf(agent, t)?.bundle ?? [];
    let bid = NaN;
    for (let i = 0; i + 1 < bundle.length; i += 2) if (bundle[i] === task) bid = bundle[i + 1];
    const { winners, bids } = model.beliefs(agent, t);
    const state = model.fleet.stateOf(agent, t);
    return { agent, state, bid, believes: { owner: winners[slot] ?? NOBODY, bid: bids[slot] } };
  });
}
