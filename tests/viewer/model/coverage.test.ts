// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { legendOf, placesOf } from '../../../sim/viewer/src/model/colouring';
import { coverageOf, isTooNear, marksOf, type Samples } from '../../../sim/viewer/src/model/coverage';
import { normalise } from '../../../sim/viewer/src/model/data';
import { clearanceText, shareText } from '../../../sim/viewer/src/text';
import { distance, labOf, seenBy, VISIONS } from './colour_vision';

const base64 = (array: ArrayBufferView): string => Buffer.from(array.buffer).toString('base64');

const figures = {
  surface_samples: 9, visible_samples: 3, covered_samples: 1, covered_visible_samples: 1, coverage_of_visible: 1 / 3, coverage_of_total: 1 / 9,
  spacing_m: 0.3, flown_m: 10, metres_per_m2: 0.5, safety_m: 2, tolerance_m: 0.001, below_floor_m: 0,
};
/** One of each class. */
const raw = {
  ...figures,
  uncovered: [{ reason: 'missed', count: 1 }],
  clearance: [{ agent: 4, nearest: { distance_m: 1.9, leg: 1, at_m: [1, 2, 3] } }, { agent: 2, nearest: { distance_m: 2.5, leg: 0, at_m: [4, 5, 6] } }, { agent: 3, nearest: null }],
  samples: {
    total: 90, classes: [10, 20, 5, 6, 7, 1, 2, 4, 35], stretches: [4, 0, 0, 0, 0, 0, 6],
    positions: base64(new Float32Array(27).fill(1.5)), normals: base64(new Int8Array(27).fill(-127)),
    class: base64(new Uint8Array([0, 1, 2, 3, 4, 5, 6, 7, 8])), seen_by: base64(new Uint16Array([5, 0, 0, 0, 0, 0, 0, 0, 0])),
  },
};
const samples = (): Samples => coverageOf(raw)!.samples!;

test('a certificate reads back, and is missing where there is none', () => {
  const { coverage } = normalise({ schema: 1, coverage: raw });
  assert.deepEqual(coverage!.figures, figures);
  assert.deepEqual(coverage!.uncovered, raw.uncovered);
  assert.equal(coverage!.samples!.positions[26], 1.5);
  assert.equal(coverage!.samples!.normals[26], -127);
  assert.equal(coverage!.samples!.seenBy[0], 5);
  assert.equal(normalise({ schema: 1 }).coverage, undefined);
});

test('what is damaged leaves the rest', () => {
  assert.deepEqual(coverageOf({ problem: 'certificate.json: not JSON' }),
    { problem: 'certificate.json: not JSON', figures: undefined, uncovered: [], clearance: [], samples: undefined });
  for (const part of ['positions', 'normals', 'class', 'seen_by']) {
    const short = coverageOf({ ...raw, samples: { ...raw.samples, [part]: base64(new Uint8Array(8)) } })!;
    assert.equal(short.samples, undefined, part);
    assert.deepEqual(short.figures, figures);
  }
  assert.equal(coverageOf({ ...raw, samples: undefined })!.samples, undefined);
  assert.equal(coverageOf({ ...raw, clearance: [{ agent: 1, nearest: { distance_m: 1 } }] })!.clearance[0].nearest, null);
});

test('legends count all samples, each once', () => {
  const counts = (colouring: 'coverage' | 'redundancy'): number[] => legendOf(samples(), colouring, false).map(({ count }) => count);
  assert.deepEqual(counts('coverage'), [10, 20, 5, 6, 7, 7, 35]);
  assert.deepEqual(counts('redundancy'), [80, 4, 0, 0, 0, 0, 0, 6]);
  const names = legendOf(samples(), 'redundancy', false).map(({ name }) => name.replace(' m of the routes', ''));
  assert.deepEqual(names, ['not covered', 'seen from 1', 'seen from 2', 'seen from 3 to 4', 'seen from 5 to 8', 'seen from 9 to 16', 'seen from 17 to 32', 'seen from 33 and more']);
  assert.deepEqual(legendOf(samples(), 'plain', false), []);
});

test('each shown sample has its place in both legends', () => {
  const places = placesOf(samples());
  const column = (offset: number): number[] => [...places].filter((_, i) => i % 4 === offset);
  assert.deepEqual(column(0), [0, 1, 2, 3, 4, 5, 5, 5, 6]);
  assert.deepEqual(column(1), [4, 0, 0, 0, 0, 0, 0, 0, 0]);
  const bins = [1, 2, 3, 4, 5, 8, 9, 16, 17, 32, 33, 65535];
  const covered: Samples = { ...samples(), class: new Uint8Array(bins.length), seenBy: new Uint16Array(bins) };
  assert.deepEqual([...placesOf(covered)].filter((_, i) => i % 4 === 1), [1, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7]);
});

test('every kind of colour vision tells the colours of a legend apart', () => {
  for (const dark of [false, true]) for (const vision of Object.keys(VISIONS)) {
    const labs = legendOf(samples(), 'coverage', dark).map(({ rgb }) => labOf(seenBy(vision, rgb)));
    labs.forEach((a, i) => labs.slice(i + 1).forEach((b, k) =>
      assert.ok(distance(a, b) > 12, `${vision}, ${dark ? 'dark' : 'light'}: colours ${i} and ${i + 1 + k} are ${distance(a, b).toFixed(1)} apart`)));
  }
});

test('redundancy goes from the background away in even steps, and what is not covered is none of them', () => {
  for (const dark of [false, true]) for (const vision of Object.keys(VISIONS)) {
    const [none, ...ramp] = legendOf(samples(), 'redundancy', dark).map(({ rgb }) => labOf(seenBy(vision, rgb)));
    const steps = ramp.slice(1).map((lab, i) => (dark ? 1 : -1) * (lab[0] - ramp[i][0]));
    assert.ok(Math.min(...steps) > 6 && Math.max(...steps) < 14, `${vision}, ${dark ? 'dark' : 'light'}: ${steps.map((step) => step.toFixed(1))}`);
    for (const lab of ramp) assert.ok(distance(none, lab) > 25, `${vision}, ${dark ? 'dark' : 'light'}: ${distance(none, lab).toFixed(1)}`);
  }
});

test('clearances go by agent; too near is what the certificate takes for it', () => {
  const coverage = coverageOf(raw)!;
  const marks = marksOf(coverage);
  assert.deepEqual(marks.map(({ agent }) => agent), [2, 4]);
  assert.deepEqual(marks.map(({ nearest }) => clearanceText(nearest, coverage.figures)), ['2.50 m', '1.90 m < 2 m']);
  const at = (distance_m: number): boolean => isTooNear({ distance_m, leg: 0, at_m: [0, 0, 0] }, coverage.figures);
  assert.deepEqual([at(1.998), at(1.9995), at(2)], [true, false, false]);
  assert.deepEqual(marksOf(undefined), []);
});

test('what is not all is never 100 %', () => {
  assert.deepEqual([1, 0.9999999, 0.9951, 0.5, 0].map(shareText), ['100.0 %', '99.999 %', '99.510 %', '50.0 %', '0.0 %']);
});
