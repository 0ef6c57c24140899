// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LinkHistory } from '../../../sim/viewer/src/model/links';
import { Mission } from '../../../sim/viewer/src/model/mission';

const agents = [{ agent: 1, home: [0, 0, 0], speed_mps: 1 }, { agent: 2, home: [9, 9, 0], speed_mps: 1 }];
const route = { agent: 1, length_m: 20, time_s: 20, line: [0, 0, 0, 0, 0, 10, 10, 0, 10], at_s: [0, 10, 20], arc: [-1, 4] };

test('a drone is where its route is at that time', () => {
  const mission = new Mission(agents, [route]);
  assert.deepEqual(mission.placeOf(1, -1), { position: [0, 0, 0], arc: -1, flying: false });
  assert.deepEqual(mission.placeOf(1, 5), { position: [0, 0, 5], arc: -1, flying: true });
  assert.deepEqual(mission.placeOf(1, 10), { position: [0, 0, 10], arc: 4, flying: true });
  assert.deepEqual(mission.placeOf(1, 17), { position: [7, 0, 10], arc: 4, flying: true });
  assert.deepEqual(mission.placeOf(1, 99), { position: [10, 0, 10], arc: -1, flying: false });
  assert.deepEqual(mission.landings(), [{ agent: 1, t_s: 20 }]);
  assert.equal(mission.duration_s, 20);
});

test('an agent without a route stays at home', () => {
  assert.deepEqual(new Mission(agents, [route]).placeOf(2, 5).position, [9, 9, 0]);
  assert.equal(new Mission(agents, []).known, false);
});

test('a route that stands still for a while, or has one vertex, is no trouble', () => {
  const waits = { ...route, at_s: [0, 0, 4], line: [1, 1, 1, 1, 1, 1, 5, 1, 1] };
  assert.deepEqual(new Mission(agents, [waits]).placeOf(1, 1).position, [2, 1, 1]);
  const point = { ...route, at_s: [0], line: [3, 3, 3], arc: [] };
  assert.deepEqual(new Mission(agents, [point]).placeOf(1, 1).position, [3, 3, 3]);
});

test('links count whole bins up to the moment, for as long as is asked', () => {
  const rows = [[0, 1, 2, 4, 1, 0, 0], [1, 1, 2, 2, 2, 1, 0], [1, 2, 1, 3, 0, 0, 1], [2, 1, 2, 8, 8, 0, 0], [1, 1, 99, 5, 5, 0, 0]];
  const links = new LinkHistory([1, 2], { bin_s: 0.05, rows });
  const at = (t: number, window: number): number[][] => { const { sent, lost } = links.at(t, window); return [[...sent], [...lost]]; };
  assert.deepEqual(at(0.07, 0.05), [[0, 2, 3, 0], [0, 2, 0, 0]]);
  assert.deepEqual(at(0.07, 0.1), [[0, 6, 3, 0], [0, 3, 0, 0]]);
  assert.deepEqual(at(0.07, 0.06), at(0.07, 0.1));
  assert.deepEqual(at(9, Infinity), [[0, 14, 3, 0], [0, 11, 0, 0]]);
  assert.deepEqual(at(0.15 - 1e-12, 0.05)[0], [0, 0, 0, 0], 'a bin is the one that a rounded time means');
  assert.deepEqual([...links.at(0.07, 0.05).delayed, ...links.at(0.07, 0.05).duplicated], [0, 1, 0, 0, 0, 0, 1, 0]);
});
