// SPDX-License-Identifier: GPL-3.0-or-later
// What the structure's colours may mean: nothing, what became of each sample, or how often it was seen.
import type { Samples } from './coverage';
import { rgbOf, type Rgb } from './palette';

export const COLOURINGS = ['plain', 'coverage', 'redundancy'] as const;
export type Colouring = (typeof COLOURINGS)[number];

/** Classes of samples as the certificate numbers them, put together where one colour says enough. */
const GROUPS: [string, number[]][] = [
  ['covered', [0]], ['visible but missed', [1]], ['visible, not assigned', [2]], ['invisible: too close to the ground', [3]],
  ['invisible: unreachable', [4]], ['invisible: beyond the sensor\'s limits', [5, 6, 7]], ['invisible: occluded', [8]],
];
/** Fewest stretches of 1 m of the routes that see a sample of each bin; before them stands what is not covered. */
const BINS = [1, 2, 3, 5, 9, 17, 33];

// Okabe and Ito's colours, as the arcs have them. What was seen, and what cannot be, is calm.
const GROUPS_LIGHT = ['#56b4e9', '#d55e00', '#e69f00', '#f0e442', '#cc79a7', '#009e73', '#4d545c'];
const GROUPS_DARK = ['#3d94d6', '#e05a10', '#e69f00', '#f0e442', '#d68cb4', '#00b083', '#4b545e'];
// One hue in even steps of lightness: the more, the more it differs from the background. Orange, which no kind of
// colour vision takes for blue, is what was not covered.
const BINS_LIGHT = ['#d55e00', '#c6dcf2', '#a3c4e6', '#80abd9', '#5c91ca', '#3a76b6', '#205b98', '#0b3f76'];
const BINS_DARK = ['#f0701d', '#15385f', '#20507f', '#2f699f', '#4a84bb', '#6fa1d3', '#9bc0e6', '#cbe0f6'];

export interface Entry { name: string; css: string; rgb: Rgb; count: number }

const coloursOf = (colouring: Colouring, dark: boolean): string[] =>
  colouring === 'plain' ? [] : colouring === 'coverage' ? (dark ? GROUPS_DARK : GROUPS_LIGHT) : dark ? BINS_DARK : BINS_LIGHT;

function binName(bin: number): string {
  const from = BINS[bin], next = BINS[bin + 1];
  if (next === undefined) return `seen from ${from} m of the routes and more`;
  return `seen from ${next - from === 1 ? from : `${from} to ${next - 1}`} m of the routes`;
}

const sum = (counts: number[]): number => counts.reduce((total, count) => total + (count ?? 0), 0);

/** Every colour, what it means, and how many of all samples have it. */
export function legendOf(samples: Samples, colouring: Colouring, dark: boolean): Entry[] {
  const { classes, stretches, total } = samples;
  const meanings: [string, number][] = colouring === 'coverage'
    ? GROUPS.map(([name, members]) => [name, sum(members.map((one) => classes[one]))])
    : [['not covered', total - (classes[0] ?? 0)], ...BINS.map((_, bin): [string, number] => [binName(bin), stretches[bin] ?? 0])];
  return coloursOf(colouring, dark).map((css, i) => ({ css, rgb: rgbOf(css), name: meanings[i][0], count: meanings[i][1] }));
}

const groupOf = (one: number): number => GROUPS.findIndex(([, members]) => members.includes(one));

function binOf(one: number, seenBy: number): number {
  if (one !== 0) return 0;
  let bin = 1;
  while (bin < BINS.length && seenBy >= BINS[bin]) bin++;
  return bin;
}

/** For each shown sample its places in both legends, and two bytes that make a whole number of words of it. */
export function placesOf({ class: classes, seenBy }: Samples): Uint8Array {
  const places = new Uint8Array(4 * classes.length);
  classes.forEach((one, i) => {
    places[4 * i] = Math.max(groupOf(one), 0);
    places[4 * i + 1] = binOf(one, seenBy[i]);
  });
  return places;
}
