// SPDX-License-Identifier: GPL-3.0-or-later
// A made certificate of the made bridge: both sides of points of its deck and piers, of every class.
import { seeded } from './random.mjs';

const base64 = (array) => Buffer.from(array.buffer).toString('base64');
const SPAN = 120, HALF = 7, DECK = 18, PIERS = [15, 45, 75, 105];
const OCCLUDED = 8;

/** A point of the surface and its outer normal. */
function surfacePoint(random) {
  const u = random(), v = random(), part = random();
  if (part < 0.4) return { at: [u * SPAN, (2 * v - 1) * HALF, DECK], normal: [0, 0, 1] };
  if (part < 0.7) return { at: [u * SPAN, (2 * v - 1) * HALF, DECK - 1.2], normal: [0, 0, -1] };
  const angle = 2 * Math.PI * u, x = PIERS[Math.floor(4 * random())];
  return { at: [x + 1.4 * Math.cos(angle), 4.2 * Math.sin(angle), v * (DECK - 2.8)], normal: [Math.cos(angle), Math.sin(angle), 0] };
}

/** Patches of every class on what is outside. */
function classOf([x, y, z]) {
  if (z < 2) return 3;
  if (z < DECK - 2) return x > 100 ? 1 : 0;
  if (z < DECK - 1) return x < 20 ? 4 : x < 40 ? 5 + (Math.floor(x) % 3) : 0;
  return x > 60 && x < 72 && y > 0 ? 1 : x > 84 && x < 96 ? 2 : 0;
}

const binOf = (seen) => Math.min(Math.ceil(Math.log2(seen)), 6);

export function coverage(points, routes) {
  const random = seeded(11);
  const positions = [], normals = [], classes = [], seen_by = [];
  const counts = Array(9).fill(0), stretches = Array(7).fill(0);
  for (let i = 0; i < points; i++) {
    const { at, normal } = surfacePoint(random);
    for (const side of [1, -1]) {
      const fate = side < 0 ? OCCLUDED : classOf(at);
      const seen = fate === 0 ? 1 + Math.floor(at[0] * at[0] / 200) : 0;
      positions.push(...at);
      normals.push(...normal.map((value) => Math.round(127 * side * value)));
      classes.push(fate);
      seen_by.push(seen);
      counts[fate]++;
      if (fate === 0) stretches[binOf(seen)]++;
    }
  }
  const total = 2 * points, visible = counts[0] + counts[1] + counts[2];
  const reasons = ['covered', 'missed', 'not assigned', 'too close to the ground', 'unreachable', 'out of range', 'incidence', 'gimbal', 'occluded'];
  return {
    surface_samples: total, visible_samples: visible, covered_samples: counts[0], covered_visible_samples: counts[0],
    coverage_of_visible: counts[0] / visible, coverage_of_total: counts[0] / total, spacing_m: 0.7, flown_m: 3000, metres_per_m2: 0.5,
    safety_m: 2, tolerance_m: 0.001, below_floor_m: 0, min_clearance_m: 1.5,
    uncovered: reasons.map((reason, i) => ({ reason, count: counts[i] })).filter(({ reason, count }) => reason !== 'covered' && count > 0),
    // The second agent came too near; the last did not fly.
    clearance: routes.map(({ agent, line }, i) => {
      const k = 3 * Math.floor(line.length / 6);
      return { agent, nearest: i === routes.length - 1 ? null : { distance_m: i === 1 ? 1.5 : 2 + 0.1 * i, leg: 2, at_m: line.slice(k, k + 3) } };
    }),
    samples: {
      total, classes: counts, stretches, positions: base64(new Float32Array(positions)), normals: base64(new Int8Array(normals)),
      class: base64(new Uint8Array(classes)), seen_by: base64(new Uint16Array(seen_by)),
    },
  };
}
