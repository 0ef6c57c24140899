// SPDX-License-Identifier: GPL-3.0-or-later
// View data, schema 1 (docs/VIEWER.md), as it comes and with every missing part made empty.
import { coverageOf, type Coverage } from './coverage';
import { list, number, object, text, type Json } from './json';

export interface Arc { arc: number; kind: string; line: number[] }
export interface Task { task: number; arc: number; from_m: number; to_m: number; line: number[] }
export interface Agent { agent: number; home: number[]; speed_mps: number }
export interface Change { t_s: number; round: number; z: (number | null)[] }
export interface View { agent: number; lives: number; changes: Change[] }
export interface Decision { t_s: number; agent: number; round: number; changed: boolean; bundle: number[] }
export interface State { t_s: number; agent: number; state: string }
export interface RunEvent { t_s: number; kind: string; agent: number | null; text: string }
export interface Links { bin_s: number; rows: number[][] }
export interface Route {
  agent: number; length_m: number; time_s: number; line: number[]; at_s: number[]; arc: number[];
}
export interface Explanation { t_s: number; agent: number; text: string }
export interface Auction {
  start_s: number; end_s: number;
  views: View[]; decisions: Decision[]; states: State[]; events: RunEvent[]; links: Links;
}
export interface RunData {
  name: string; run: string; live: boolean;
  build: { version: string; commit: string };
  summary: [string, string][];
  structure: { points?: string; triangles?: string };
  arcs: Arc[]; tasks: Task[]; agents: Agent[];
  auction: Auction;
  routes: Route[];
  explanations: Map<number, Explanation[]>;
  coverage: Coverage | undefined;
}

/** By time; what came at one moment keeps its order. */
function inTime<T extends { t_s: number }>(items: T[]): T[] {
  for (let i = 1; i < items.length; i++)
    if (items[i].t_s < items[i - 1].t_s) return [...items].sort((a, b) => a.t_s - b.t_s);
  return items;
}

function auctionOf(raw: Json): Auction {
  const links = object(raw.links);
  const auction: Auction = {
    start_s: 0, end_s: 0,
    views: list<Partial<View>>(raw.views).map((view) => ({
      agent: number(view.agent, 0), lives: number(view.lives, 1), changes: inTime(list<Change>(view.changes)),
    })),
    decisions: inTime(list<Decision>(raw.decisions)),
    states: inTime(list<State>(raw.states)),
    events: inTime(list<RunEvent>(raw.events)),
    links: { bin_s: number(links.bin_s, 0), rows: list<number[]>(links.rows) },
  };
  const [first, last] = extent(auction);
  auction.start_s = number(raw.start_s, first);
  auction.end_s = Math.max(number(raw.end_s, last), auction.start_s);
  return auction;
}

/**
 * The first and the last moment at which something happened. Of a state only the end counts:
 * processes wait long before there is anything to see.
 */
export function extent(auction: Auction): [number, number] {
  let first = Infinity, last = -Infinity;
  const ordered: { t_s: number }[][] = [auction.decisions, auction.events, ...auction.views.map((view) => view.changes)];
  for (const items of ordered) {
    if (items.length === 0) continue;
    first = Math.min(first, items[0].t_s);
    last = Math.max(last, items[items.length - 1].t_s);
  }
  for (const { t_s } of auction.states) last = Math.max(last, t_s);
  return first <= last ? [first, last] : [Math.max(last, 0), Math.max(last, 0)];
}

/** Throws with one line for what is no view data at all; whatever else is missing is empty. */
export function normalise(raw: unknown): RunData {
  const data = object(raw);
  if (data.schema !== 1) throw new Error(`view data: schema: ${JSON.stringify(data.schema)}; legal: 1`);
  const build = object(data.build);
  const structure = object(data.structure);
  const explanations = new Map<number, Explanation[]>();
  for (const [task, said] of Object.entries(object(data.explanations)))
    explanations.set(Number(task), inTime(list<Explanation>(said)));
  return {
    name: text(data.name), run: text(data.run), live: data.live === true,
    build: { version: text(build.version), commit: text(build.commit) },
    summary: list<[string, string]>(data.summary),
    structure: {
      points: text(structure.points) || undefined,
      triangles: text(structure.triangles) || undefined,
    },
    arcs: list(data.arcs), tasks: list(data.tasks), agents: list(data.agents),
    auction: auctionOf(object(data.auction)),
    routes: list(object(data.mission).routes),
    explanations,
    coverage: coverageOf(data.coverage),
  };
}
