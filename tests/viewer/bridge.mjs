// SPDX-License-Identifier: GPL-3.0-or-later
// A made bridge: points on deck, girders and piers, and the arcs flown around them.

const SPAN = 120, HALF = 7, DECK = 18;
const round = (value) => Math.round(value * 1000) / 1000;

/** [share of the points, a point of it], each of two numbers in [0, 1). */
const parts = [
  [0.34, (u, v) => [u * SPAN, (2 * v - 1) * HALF, DECK]],
  [0.16, (u, v) => [u * SPAN, (2 * v - 1) * HALF * 0.9, DECK - 1.2]],
  [0.08, (u, v) => [u * SPAN, HALF, DECK + 1.1 * v]],
  [0.08, (u, v) => [u * SPAN, -HALF, DECK + 1.1 * v]],
  [0.07, (u, v) => [u * SPAN, 4, DECK - 1.2 - 1.6 * v]],
  [0.07, (u, v) => [u * SPAN, -4, DECK - 1.2 - 1.6 * v]],
  ...[15, 45, 75, 105].map((x) => [0.05, (u, v) => {
    const angle = 2 * Math.PI * u;
    return [x + 1.4 * Math.cos(angle), 4.2 * Math.sin(angle), v * (DECK - 2.8)];
  }]),
];

export function bridgePoints(count, random) {
  const points = new Float32Array(count * 3);
  let part = 0, left = Math.ceil(parts[0][0] * count);
  for (let i = 0; i < count; i++) {
    if (left-- <= 0 && part + 1 < parts.length) left = Math.ceil(parts[++part][0] * count);
    const jitter = () => (random() - 0.5) * 0.12;
    points.set(parts[part][1](random(), random()).map((value) => value + jitter()), 3 * i);
  }
  return points;
}

function straight(kind, y, z, step) {
  const line = [];
  for (let x = 0; x <= SPAN + 1e-9; x += step) line.push(round(x), round(y), round(z));
  return { kind, line };
}

function ring(x, z) {
  const line = [];
  for (let k = 0; k <= 16; k++) {
    const angle = (2 * Math.PI * k) / 16;
    line.push(round(x + 4.5 * Math.cos(angle)), round(7.5 * Math.sin(angle)), round(z));
  }
  return { kind: 'outline', line };
}

/** `rows` lines over and under the deck each, two along its sides, rings around the piers. */
export function bridgeArcs(rows) {
  const arcs = [];
  const across = (i) => (rows === 1 ? 0 : -HALF + (2 * HALF * i) / (rows - 1));
  for (let i = 0; i < rows; i++) arcs.push(straight('top_row', across(i), DECK + 5, 5));
  for (let i = 0; i < rows; i++) arcs.push(straight('underside_row', across(i), DECK - 6, 5));
  for (const y of [HALF + 4, -HALF - 4]) arcs.push(straight('outline', y, DECK, 5));
  for (const x of [15, 45, 75, 105]) for (const z of [3, 7, 10.5]) arcs.push(ring(x, z));
  return arcs.map((arc, i) => ({ arc: i, ...arc }));
}

export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
export const vertex = (line, k) => line.slice(3 * k, 3 * k + 3);

/** Pieces of about `length` metres that tile each arc, cut at its vertices. */
export function pieces(arcs, length) {
  const tasks = [];
  for (const { arc, line } of arcs) {
    let at = 0, from = 0, first = 0;
    const vertices = line.length / 3;
    for (let k = 1; k < vertices; k++) {
      at += distance(vertex(line, k - 1), vertex(line, k));
      if (at - from < length && k + 1 < vertices) continue;
      tasks.push({ task: tasks.length, arc, from_m: from, to_m: at, line: line.slice(3 * first, 3 * k + 3) });
      from = at;
      first = k;
    }
  }
  return tasks;
}
