// SPDX-License-Identifier: GPL-3.0-or-later
// A shape for each kind of event: told apart without colour.
import { svg } from './dom';

const PATHS: Record<string, string> = {
  mission: 'M2 2h8v8h-8z',
  start: 'M3 1.5l7 4.5-7 4.5z',
  conflict: 'M6 1l5 10H1z',
  death: 'M2 2l8 8M10 2l-8 8',
  return: 'M6 11V2M2.5 5.5L6 2l3.5 3.5',
  partition: 'M4 1v10M8 1v10',
  heal: 'M1 6h10M4 3L1 6l3 3M8 3l3 3-3 3',
  fault: 'M7 1L3 7h3l-1 4 4-6H6z',
  agreement: 'M1.5 6.5l3 3 6-7',
  reopened: 'M10 6a4 4 0 1 1-1.5-3.1M8.5 0.5v3h-3',
  route: 'M1 10l3-6 4 3 3-6',
  refused: 'M6 1a5 5 0 1 0 .01 0M2.5 9.5l7-7',
  end: 'M2 1v10M2 1.5h8l-2 2.5 2 2.5H2',
};
const FILLED = new Set(['mission', 'start', 'fault']);
/** Those that one looks for first. */
const GRAVE = new Set(['death', 'partition', 'conflict', 'refused']);

export function eventMark(kind: string): SVGElement {
  const path = svg('path', { d: PATHS[kind] ?? 'M6 3a3 3 0 1 0 .01 0' });
  const look = `${FILLED.has(kind) ? 'filled' : 'drawn'} ${GRAVE.has(kind) ? 'grave' : kind === 'agreement' ? 'good' : ''}`;
  return svg('svg', { class: `event-mark ${look}`, width: 12, height: 12, viewBox: '0 0 12 12', 'aria-hidden': 'true' }, path);
}
