// SPDX-License-Identifier: GPL-3.0-or-later
// Messages sent and lost between any two agents, as they went.
import type { Links } from './data';
import { countUpTo } from './search';

export interface LinkCounts { sent: Float64Array; lost: Float64Array; delayed: Float64Array; duplicated: Float64Array }

export class LinkHistory {
  readonly size: number;
  private readonly rows: number[][];

  constructor(readonly agents: number[], private readonly links: Links) {
    this.size = agents.length;
    const index = new Map(agents.map((agent, i) => [agent, i]));
    this.rows = links.rows
      .filter((row) => index.has(row[1]) && index.has(row[2]))
      .map(([bin, from, to, ...counts]) => [bin, index.get(from)! * this.size + index.get(to)!, ...counts])
      .sort((a, b) => a[0] - b[0]);
  }

  get known(): boolean { return this.rows.length > 0 && this.links.bin_s > 0; }

  /** A time that is a whole number of bins may have come out a little less. */
  binAt(t: number): number { return this.known ? Math.floor(t / this.links.bin_s + 1e-9) : 0; }

  /** Cell [from * size + to] of what went in the `window_s` seconds before `t` (whole bins). */
  at(t: number, window_s: number): LinkCounts {
    const cells = this.size * this.size;
    const counts: LinkCounts = {
      sent: new Float64Array(cells), lost: new Float64Array(cells),
      delayed: new Float64Array(cells), duplicated: new Float64Array(cells),
    };
    if (!this.known) return counts;
    const last = this.binAt(t);
    const first = last - Math.ceil(window_s / this.links.bin_s);
    const bin = (i: number): number => this.rows[i][0];
    const end = countUpTo(this.rows.length, bin, last);
    for (let i = countUpTo(this.rows.length, bin, first); i < end; i++) {
      const [, cell, sent, lost, delayed, duplicated] = this.rows[i];
      counts.sent[cell] += sent;
      counts.lost[cell] += lost;
      counts.delayed[cell] += delayed ?? 0;
      counts.duplicated[cell] += duplicated ?? 0;
    }
    return counts;
  }
}
