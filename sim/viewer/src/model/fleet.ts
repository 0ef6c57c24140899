// SPDX-License-Identifier: GPL-3.0-or-later
// What the fleet as a whole has decided: the newest bundle of each living agent.
import type { Auction, Decision } from './data';
import { NOBODY } from './beliefs';
import { countUpTo } from './search';

interface Life { t_s: number; alive: boolean }

/** The task table of the fleet at a moment; `claims` counts who has a piece in its bundle. */
export interface Allocation { winners: Float64Array; bids: Float64Array; claims: Uint8Array }

export class Fleet {
  private readonly decisions = new Map<number, Decision[]>();
  private readonly lives = new Map<number, Life[]>();
  private readonly states = new Map<number, { t_s: number; state: string }[]>();

  constructor(private readonly agents: number[], auction: Auction, private readonly slots: Map<number, number>) {
    for (const agent of agents) {
      this.decisions.set(agent, []);
      this.lives.set(agent, []);
      this.states.set(agent, []);
    }
    for (const decision of auction.decisions) this.decisions.get(decision.agent)?.push(decision);
    for (const state of auction.states) {
      this.states.get(state.agent)?.push(state);
      // A process that was killed has ended too: that is no return.
      if (state.state !== 'ended') this.lives.get(state.agent)?.push({ t_s: state.t_s, alive: state.state !== 'dead' });
    }
    // An agent's own states say best when it lived; events stand in where there are none.
    for (const { kind, agent, t_s } of auction.events)
      if (agent !== null && (kind === 'death' || kind === 'return') && this.states.get(agent)?.length === 0)
        this.lives.get(agent)?.push({ t_s, alive: kind === 'return' });
  }

  isAlive(agent: number, t: number): boolean {
    const lives = this.lives.get(agent) ?? [];
    const known = countUpTo(lives.length, (i) => lives[i].t_s, t);
    return known === 0 || lives[known - 1].alive;
  }

  /** '' before anything is known. */
  stateOf(agent: number, t: number): string {
    const states = this.states.get(agent) ?? [];
    const known = countUpTo(states.length, (i) => states[i].t_s, t);
    if (known > 0) return states[known - 1].state;
    return this.isAlive(agent, t) ? '' : 'dead';
  }

  /** When the life began in which the agent is at `t`. */
  bornAt(agent: number, t: number): number {
    const lives = this.lives.get(agent) ?? [];
    for (let i = countUpTo(lives.length, (k) => lives[k].t_s, t) - 1; i >= 0; i--)
      if (!lives[i].alive) return lives[i].t_s;
    return -Infinity;
  }

  /** The newest decision that still stands: none of the dead, none of a life before this one. */
  decisionOf(agent: number, t: number): Decision | undefined {
    if (!this.isAlive(agent, t)) return undefined;
    const made = this.decisions.get(agent) ?? [];
    const count = countUpTo(made.length, (i) => made[i].t_s, t);
    const newest = count > 0 ? made[count - 1] : undefined;
    return newest && newest.t_s >= this.bornAt(agent, t) ? newest : undefined;
  }

  /** Higher bid wins, on ties the lower id. */
  at(t: number): Allocation {
    const size = this.slots.size;
    const table: Allocation = {
      winners: new Float64Array(size).fill(NOBODY), bids: new Float64Array(size).fill(NaN), claims: new Uint8Array(size),
    };
    for (const agent of this.agents) {
      const bundle = this.decisionOf(agent, t)?.bundle ?? [];
      for (let i = 0; i + 1 < bundle.length; i += 2) this.claim(table, agent, bundle[i], bundle[i + 1]);
    }
    return table;
  }

  private claim(table: Allocation, agent: number, task: number, bid: number): void {
    const slot = this.slots.get(task);
    if (slot === undefined) return;
    table.claims[slot]++;
    const best = table.bids[slot];
    if (Number.isNaN(best) || bid > best || (bid === best && agent < table.winners[slot])) {
      table.bids[slot] = bid;
      table.winners[slot] = agent;
    }
  }

  roundAt(t: number): number {
    let round = 0;
    for (const agent of this.agents) round = Math.max(round, this.decisionOf(agent, t)?.round ?? 0);
    return round;
  }
}
