// SPDX-License-Identifier: GPL-3.0-or-later
// What a certificate says of the run: how much of the surface was seen, and how near routes came to it.
import { bytesOf, floatsOf } from './decode';
import { list, number, object, text, type Json } from './json';

export interface Nearest { distance_m: number; leg: number; at_m: number[] }
export interface Clearance { agent: number; nearest: Nearest | null }
export interface Uncovered { reason: string; count: number }
export interface Figures {
  surface_samples: number; visible_samples: number; covered_samples: number; covered_visible_samples: number;
  coverage_of_visible: number; coverage_of_total: number; spacing_m: number; flown_m: number; metres_per_m2: number;
  safety_m: number; tolerance_m: number; below_floor_m: number;
}
const FIGURES: (keyof Figures)[] = [
  'surface_samples', 'visible_samples', 'covered_samples', 'covered_visible_samples', 'coverage_of_visible', 'coverage_of_total',
  'spacing_m', 'flown_m', 'metres_per_m2', 'safety_m', 'tolerance_m', 'below_floor_m',
];
/** Sides of surface points: some of them, and how many there are of each class and of each bin of redundancy. */
export interface Samples {
  total: number; classes: number[]; stretches: number[];
  positions: Float32Array; normals: Int8Array; class: Uint8Array; seenBy: Uint16Array;
}
export interface Coverage {
  /** Why there is no more of it; empty: there is all. */
  problem: string;
  figures: Figures | undefined;
  uncovered: Uncovered[];
  clearance: Clearance[];
  samples: Samples | undefined;
}

function samplesOf(raw: Json): Samples | undefined {
  const seen = bytesOf(text(raw.seen_by));
  const samples: Samples = {
    total: number(raw.total, 0), classes: list(raw.classes), stretches: list(raw.stretches),
    positions: floatsOf(text(raw.positions)), normals: new Int8Array(bytesOf(text(raw.normals)).buffer),
    class: bytesOf(text(raw.class)), seenBy: new Uint16Array(seen.buffer, 0, seen.length >> 1),
  };
  const count = samples.class.length;
  const whole = samples.positions.length === 3 * count && samples.normals.length === 3 * count && samples.seenBy.length === count;
  return whole && count > 0 ? samples : undefined;
}

function nearestOf(raw: unknown): Nearest | null {
  const { distance_m, leg, at_m } = object(raw);
  const at = list<number>(at_m);
  return typeof distance_m === 'number' && at.length === 3 ? { distance_m, leg: number(leg, 0), at_m: at } : null;
}

/** Undefined: the run has no certificate. */
export function coverageOf(value: unknown): Coverage | undefined {
  if (value === undefined || value === null) return undefined;
  const raw = object(value);
  const known = FIGURES.every((name) => typeof raw[name] === 'number');
  return {
    problem: text(raw.problem),
    figures: known ? (Object.fromEntries(FIGURES.map((name) => [name, raw[name]])) as unknown as Figures) : undefined,
    uncovered: list<Json>(raw.uncovered).map((one) => ({ reason: text(one.reason), count: number(one.count, 0) })),
    clearance: list<Json>(raw.clearance).map((one) => ({ agent: number(one.agent, 0), nearest: nearestOf(one.nearest) })),
    samples: known ? samplesOf(object(raw.samples)) : undefined,
  };
}

/** Those that flew, by agent. */
export const marksOf = (coverage: Coverage | undefined): { agent: number; nearest: Nearest }[] =>
  (coverage?.clearance ?? []).flatMap(({ agent, nearest }) => (nearest ? [{ agent, nearest }] : [])).sort((a, b) => a.agent - b.agent);

/** As the certificate judges it: nearer than was asked for by more than the measure may err. */
export const isTooNear = ({ distance_m }: Nearest, figures: Figures | undefined): boolean =>
  figures !== undefined && distance_m < figures.safety_m - figures.tolerance_m;
