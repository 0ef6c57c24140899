// SPDX-License-Identifier: GPL-3.0-or-later
// z_i and y_i of one agent at any time.
import type { View } from './data';
import { countUpTo } from './search';

export interface Beliefs { winners: Float64Array; bids: Float64Array }

export const NOBODY = -1;

const emptyBeliefs = (tasks: number): Beliefs => ({
  winners: new Float64Array(tasks).fill(NOBODY), bids: new Float64Array(tasks).fill(NaN),
});

/**
 * Changes lie flat; every so many of them the whole table is kept, so that a seek replays few
 * of them however many there are. The distance grows with the table: both together stay linear.
 */
export class BeliefHistory {
  readonly agent: number;
  readonly times: Float64Array;
  /** Entries the last seek had to replay. */
  replayed = 0;
  readonly spacing: number;
  private readonly ends: Uint32Array;
  private readonly tasks: Int32Array;
  private readonly winners: Float64Array;
  private readonly bids: Float64Array;
  private readonly keyframes: Beliefs[] = [];
  private readonly now: Beliefs;
  private done = 0;

  constructor(view: View, slots: Map<number, number>, spacing = 4096) {
    this.agent = view.agent;
    this.spacing = Math.max(spacing, 2 * slots.size);
    this.times = Float64Array.from(view.changes, (change) => change.t_s);
    this.ends = new Uint32Array(view.changes.length);
    let total = 0;
    view.changes.forEach((change, i) => (this.ends[i] = total += Math.floor(change.z.length / 3)));
    this.tasks = new Int32Array(total);
    this.winners = new Float64Array(total);
    this.bids = new Float64Array(total);
    this.now = emptyBeliefs(slots.size);
    this.fill(view, slots);
    this.makeKeyframes();
  }

  private fill(view: View, slots: Map<number, number>): void {
    let k = 0;
    for (const { z } of view.changes)
      for (let i = 0; i + 2 < z.length; i += 3, k++) {
        this.tasks[k] = slots.get(z[i] as number) ?? -1;
        this.winners[k] = z[i + 1] ?? NOBODY;
        this.bids[k] = z[i + 2] ?? NaN;
      }
  }

  private makeKeyframes(): void {
    const table = emptyBeliefs(this.now.winners.length);
    this.keyframes.push({ winners: table.winners.slice(), bids: table.bids.slice() });
    for (let k = 0; k < this.tasks.length; k++) {
      this.apply(table, k);
      if ((k + 1) % this.spacing === 0)
        this.keyframes.push({ winners: table.winners.slice(), bids: table.bids.slice() });
    }
  }

  private apply(table: Beliefs, entry: number): void {
    const slot = this.tasks[entry];
    if (slot < 0) return;
    table.winners[slot] = this.winners[entry];
    table.bids[slot] = this.bids[entry];
  }

  /** The table at `t`; it is this history's own and good until the next call. */
  at(t: number): Beliefs {
    const changes = countUpTo(this.times.length, (i) => this.times[i], t);
    const target = changes > 0 ? this.ends[changes - 1] : 0;
    const frame = Math.floor(target / this.spacing);
    let from = this.done;
    if (target < this.done || frame * this.spacing > this.done) {
      from = frame * this.spacing;
      this.now.winners.set(this.keyframes[frame].winners);
      this.now.bids.set(this.keyframes[frame].bids);
    }
    for (let k = from; k < target; k++) this.apply(this.now, k);
    this.replayed = target - from;
    this.done = target;
    return this.now;
  }
}
