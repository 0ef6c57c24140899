// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { ViewModel } from '../../../sim/viewer/src/model/view_model';
import { roundReport, stancesOn } from '../../../sim/viewer/src/model/rounds';
import { decision, run } from './run';

const owners = (model: ViewModel, t: number): number[] => [...model.owners('fleet', t)];

test('the highest bid has a piece; on ties the lower id', () => {
  const model = run({ decisions: [decision(1, 3, [10, -5, 11, -6]), decision(2, 2, [10, -4, 11, -6]), decision(3, 1, [11, -6, 12, -9])] });
  assert.deepEqual(owners(model, 0.5), [-1, -1, -1]);
  assert.deepEqual(owners(model, 1), [3, 3, -1]);
  assert.deepEqual(owners(model, 2), [2, 2, -1]);
  assert.deepEqual(owners(model, 3), [2, 1, 1]);
});

test('only the newest decision of an agent counts', () => {
  const model = run({ decisions: [decision(1, 1, [10, -5]), decision(2, 1, [11, -5])] });
  assert.deepEqual(owners(model, 2), [-1, 1, -1]);
});

test('the dead own nothing, and a new life begins with nothing', () => {
  const states = [{ t_s: 0, agent: 1, state: 'bidding' }, { t_s: 3, agent: 1, state: 'dead' }, { t_s: 5, agent: 1, state: 'waiting' }];
  const model = run({ states, decisions: [decision(1, 1, [10, -5]), decision(2, 2, [10, -8]), decision(6, 1, [10, -7])] });
  assert.deepEqual(owners(model, 2.5), [1, -1, -1]);
  assert.deepEqual(owners(model, 3), [2, -1, -1]);
  assert.deepEqual(owners(model, 5.5), [2, -1, -1]);
  assert.deepEqual(owners(model, 6), [1, -1, -1]);
  assert.deepEqual([model.fleet.stateOf(1, 4), model.fleet.stateOf(1, 5), model.fleet.isAlive(1, 4)], ['dead', 'waiting', false]);
});

test('a killed process that has ended does not live again', () => {
  const model = run({ states: [{ t_s: 3, agent: 1, state: 'dead' }, { t_s: 4, agent: 1, state: 'ended' }] });
  assert.equal(model.fleet.isAlive(1, 5), false);
});

test('deaths are taken from events where there are no states', () => {
  const events = [{ t_s: 3, kind: 'death', agent: 1, text: '' }, { t_s: 4, kind: 'return', agent: 1, text: '' }];
  const model = run({ events });
  assert.deepEqual([2, 3, 4].map((t) => model.fleet.isAlive(1, t)), [true, false, true]);
});

test('disputed is what two claim, or of which two believe different things', () => {
  const views = [
    { agent: 1, changes: [{ t_s: 1, round: 1, z: [10, 1, -5, 11, 1, -6] }, { t_s: 4, round: 2, z: [11, 2, -3, 12, 3, -9] }] },
    { agent: 2, changes: [{ t_s: 2, round: 1, z: [10, 1, -5, 11, 2, -3, 12, 3, -9] }] },
  ];
  const model = run({ views, decisions: [decision(1, 1, [10, -5, 11, -6]), decision(2, 2, [11, -3]), decision(4, 1, [10, -5], 2)] });
  assert.deepEqual([...model.disputed(1)], [0, 0, 0], 'one agent alone is at one with itself');
  assert.deepEqual([...model.disputed(3)], [0, 1, 1], 'of piece 12 only the beliefs differ');
  assert.deepEqual([...model.disputed(4)], [0, 0, 0]);
});

test('two claims on one piece are a dispute even where views are missing', () => {
  const model = run({ decisions: [decision(1, 1, [12, -5]), decision(1, 2, [12, -6])] });
  assert.deepEqual([...model.disputed(1)], [0, 0, 1]);
});

test('loads add up the pieces and their metres', () => {
  const model = run({ decisions: [decision(1, 2, [10, -5, 12, -6])] });
  assert.deepEqual(model.loads(model.owners('fleet', 1)), [
    { agent: 1, tasks: 0, metres: 0 }, { agent: 2, tasks: 2, metres: 4 }, { agent: 3, tasks: 0, metres: 0 }]);
});

test('a round tells what changed hands in it, and then what only changed its price', () => {
  const model = run({ decisions: [decision(1, 1, [10, -5, 11, -6]), decision(2, 2, [11, -3], 2), decision(3, 1, [10, -4], 2)] });
  const report = roundReport(model, 3);
  assert.deepEqual([report.round, report.from_s, report.deciders], [2, 2, 2]);
  assert.deepEqual(report.changes, [
    { slot: 1, before: { owner: 1, bid: -6 }, after: { owner: 2, bid: -3 } },
    { slot: 0, before: { owner: 1, bid: -5 }, after: { owner: 1, bid: -4 } }]);
});

test('stances: each agent\'s own bid and whom it takes for the winner', () => {
  const views = [{ agent: 2, changes: [{ t_s: 1, round: 1, z: [11, 1, -6] }] }];
  const model = run({ views, decisions: [decision(1, 1, [11, -6]), decision(1, 2, [10, -2])] });
  const [first, second] = stancesOn(model, 1, 1);
  assert.deepEqual([first.bid, second.bid], [-6, NaN]);
  assert.deepEqual(second.believes, { owner: 1, bid: -6 });
});
