// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Clock } from '../../../sim/viewer/src/model/clock';
import { neighbour } from '../../../sim/viewer/src/model/search';

function clock(): Clock {
  const made = new Clock();
  made.setSpan('auction', { from: 1, to: 2 });
  made.setSpan('mission', { from: 0, to: 100 });
  made.rate.auction = 0.5;
  made.rate.mission = 10;
  return made;
}

test('time runs at its rate, takes off at the auction\'s end, and stops at the mission\'s', () => {
  const made = clock();
  made.play(true);
  made.advance(0.1);
  assert.equal(made.t, 1.05);
  made.seek(1.99);
  made.advance(0.1);
  assert.deepEqual([made.track, made.t, made.playing], ['mission', 0, true]);
  made.advance(0.05);
  assert.equal(made.t, 0.5);
  made.seek(99.9);
  made.advance(0.1);
  assert.deepEqual([made.t, made.playing], [100, false]);
});

test('a loop begins again with the auction', () => {
  const made = clock();
  made.loop = true;
  made.track = 'mission';
  made.seek(100);
  made.playing = true;
  made.advance(0.1);
  assert.deepEqual([made.track, made.t, made.playing], ['auction', 1, true]);
});

test('slow frames do not leap, and the real rate says so', () => {
  const made = clock();
  made.play(true);
  for (let i = 0; i < 3; i++) made.advance(0.4);
  assert.ok(Math.abs(made.t - 1.15) < 1e-12);
  assert.ok(Math.abs(made.realRate - 0.125) < 1e-12);
  assert.equal(made.fallsBehind, true);
  for (let i = 0; i < 20; i++) made.advance(0.05);
  assert.equal(made.fallsBehind, false, 'what is long past does not count');
});

test('play at the end starts over; a seek stays within the track', () => {
  const made = clock();
  made.seek(7);
  assert.equal(made.t, 2);
  made.play(true);
  assert.equal(made.t, 1);
  made.seek(-7);
  assert.equal(made.t, 1);
});

test('the rate that is offered lets a track last some twenty seconds', () => {
  const made = clock();
  made.suggestRate('auction');
  made.suggestRate('mission');
  assert.deepEqual([made.rate.auction, made.rate.mission], [0.05, 5]);
});

test('neighbours: the next and the previous time, beyond those that are now', () => {
  const times = [1, 2, 2, 3];
  assert.deepEqual([neighbour(times, 2, 1), neighbour(times, 2, -1), neighbour(times, 2.5, -1)], [3, 1, 2]);
  assert.deepEqual([neighbour(times, 3, 1), neighbour(times, 1, -1)], [undefined, undefined]);
});
