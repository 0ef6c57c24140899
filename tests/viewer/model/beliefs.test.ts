// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BeliefHistory } from '../../../sim/viewer/src/model/beliefs';
import { run } from './run';

const slots = new Map([[10, 0], [11, 1], [12, 2]]);

test('a belief holds from its moment on, until the next', () => {
  const model = run({ views: [{ agent: 2, lives: 1, changes: [
    { t_s: 1, round: 1, z: [10, 1, -5.5, 12, 2, -7] }, { t_s: 2, round: 2, z: [10, -1, null, 11, 3, 0.1 + 0.2] }] }] });
  const at = (t: number): number[][] => { const { winners, bids } = model.beliefs(2, t); return [[...winners], [...bids]]; };
  assert.deepEqual(at(0.999), [[-1, -1, -1], [NaN, NaN, NaN]]);
  assert.deepEqual(at(1), [[1, -1, 2], [-5.5, NaN, -7]]);
  assert.deepEqual(at(2), [[-1, 3, 2], [NaN, 0.30000000000000004, -7]]);
  assert.deepEqual(at(1.5), [[1, -1, 2], [-5.5, NaN, -7]], 'going back');
  assert.deepEqual([...model.beliefs(1, 5).winners], [-1, -1, -1], 'an agent without a view believes nothing');
});

test('changes that come out of order are put in order', () => {
  const model = run({ views: [{ agent: 1, changes: [{ t_s: 2, round: 2, z: [10, 2, -1] }, { t_s: 1, round: 1, z: [10, 1, -2] }] }] });
  assert.equal(model.beliefs(1, 3).winners[0], 2);
  assert.equal(model.beliefs(1, 1.5).winners[0], 1);
});

test('a piece that is not listed changes nothing', () => {
  const model = run({ views: [{ agent: 1, changes: [{ t_s: 1, round: 1, z: [99, 2, -1, 11, 3, -2] }] }] });
  assert.deepEqual([...model.beliefs(1, 1).winners], [-1, 3, -1]);
});

test('ids up to the largest of 32 bits are kept', () => {
  const model = run({ views: [{ agent: 1, changes: [{ t_s: 1, round: 1, z: [10, 4294967295, -1] }] }] });
  assert.equal(model.beliefs(1, 1).winners[0], 4294967295);
});

test('a seek anywhere in a million changes replays few of them, and is right', () => {
  const count = 1000000;
  const winnerOf = (k: number): number => (k * 7919) % 64;
  const changes = Array.from({ length: count / 4 }, (_, c) => ({
    t_s: c, round: c, z: [0, 1, 2, 3].flatMap((i) => [10 + ((4 * c + i) % 3), winnerOf(4 * c + i), -(4 * c + i)]),
  }));
  const history = new BeliefHistory({ agent: 1, lives: 1, changes }, slots);
  for (const t of [249999, 3, 124321.5, 200000, 199999, 0, -1]) {
    const { winners, bids } = history.at(t);
    const last = 4 * Math.floor(t) + 3;
    for (let slot = 0; slot < 3; slot++) {
      let k = last;
      while (k >= 0 && k % 3 !== slot) k--;
      assert.equal(winners[slot], k < 0 ? -1 : winnerOf(k), `piece ${slot} at ${t}`);
      assert.equal(bids[slot], k < 0 ? NaN : -k);
    }
    assert.ok(history.replayed <= history.spacing, `${history.replayed} were replayed for ${t}`);
  }
  assert.ok(history.spacing <= 4096);
});
