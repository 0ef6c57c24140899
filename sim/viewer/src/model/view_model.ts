// SPDX-License-Identifier: GPL-3.0-or-later
// Everything the page asks of a run, at any time of it.
import { BeliefHistory, NOBODY, type Beliefs } from './beliefs';
import { extent, type RunData, type RunEvent, type Task } from './data';
import { Fleet } from './fleet';
import { LinkHistory } from './links';
import { Mission } from './mission';

/** Whose idea of the owners is shown: the fleet's, or that of the agent with this id. */
export type Perspective = 'fleet' | number;

export interface Load { agent: number; tasks: number; metres: number }

export class ViewModel {
  readonly agents: number[];
  readonly tasks: Task[];
  readonly fleet: Fleet;
  readonly links: LinkHistory;
  readonly mission: Mission;
  readonly first_s: number;
  readonly last_s: number;
  /** Moments at which something was decided or believed anew, each once. */
  readonly moments: Float64Array;
  private readonly slots: Map<number, number>;
  private readonly histories = new Map<number, BeliefHistory>();
  private readonly agentSlots: Map<number, number>;

  constructor(readonly data: RunData) {
    this.agents = data.agents.map((agent) => agent.agent).sort((a, b) => a - b);
    this.agentSlots = new Map(this.agents.map((agent, i) => [agent, i]));
    this.tasks = data.tasks;
    this.slots = new Map(data.tasks.map((task, i) => [task.task, i]));
    this.fleet = new Fleet(this.agents, data.auction, this.slots);
    this.links = new LinkHistory(this.agents, data.auction.links);
    this.mission = new Mission(data.agents, data.routes);
    for (const view of data.auction.views) this.histories.set(view.agent, new BeliefHistory(view, this.slots));
    const [first, last] = extent(data.auction);
    this.first_s = Math.min(first, data.auction.start_s);
    this.last_s = Math.max(last, data.auction.end_s);
    this.moments = this.collectMoments();
  }

  private collectMoments(): Float64Array {
    const times = new Set<number>();
    for (const decision of this.data.auction.decisions) times.add(decision.t_s);
    for (const history of this.histories.values()) for (const t of history.times) times.add(t);
    return Float64Array.from(times).sort();
  }

  slotOf(task: number): number | undefined { return this.slots.get(task); }
  agentSlot(agent: number): number { return this.agentSlots.get(agent) ?? -1; }
  get events(): RunEvent[] { return this.data.auction.events; }

  /** z_i and y_i by task; good until this agent is asked again. */
  beliefs(agent: number, t: number): Beliefs {
    const known = this.histories.get(agent);
    if (known) return known.at(t);
    const size = this.tasks.length;
    return { winners: new Float64Array(size).fill(NOBODY), bids: new Float64Array(size).fill(NaN) };
  }

  owners(perspective: Perspective, t: number): Float64Array {
    return perspective === 'fleet' ? this.fleet.at(t).winners : this.beliefs(perspective, t).winners.slice();
  }

  /** 1 for a piece that two living agents claim, or of which they believe different things. */
  disputed(t: number): Uint8Array {
    const disputed = new Uint8Array(this.tasks.length);
    this.fleet.at(t).claims.forEach((count, slot) => { if (count > 1) disputed[slot] = 1; });
    let first: Float64Array | undefined;
    for (const agent of this.agents) {
      if (!this.histories.has(agent) || !this.fleet.decisionOf(agent, t)) continue;
      const { winners } = this.beliefs(agent, t);
      if (first) {
        for (let slot = 0; slot < winners.length; slot++) if (winners[slot] !== first[slot]) disputed[slot] = 1;
      } else {
        first = winners;
      }
    }
    return disputed;
  }

  /** What each agent has of `owners`, in the order of `agents`. */
  loads(owners: Float64Array): Load[] {
    const loads = this.agents.map((agent) => ({ agent, tasks: 0, metres: 0 }));
    owners.forEach((owner, slot) => {
      const load = loads[this.agentSlot(owner)];
      if (!load) return;
      load.tasks++;
      load.metres += this.tasks[slot].to_m - this.tasks[slot].from_m;
    });
    return loads;
  }
}
