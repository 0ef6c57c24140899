// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { gzipSync } from 'node:zlib';
import { test } from 'node:test';
import { normalise } from '../../../sim/viewer/src/model/data';
import { floatsOf, jsonOf, trianglesOf } from '../../../sim/viewer/src/model/decode';
import { DASHES, lookOf, PATTERNS } from '../../../sim/viewer/src/model/palette';
import { disputeSeries, loadSeries, sampleTimes, usualMost } from '../../../sim/viewer/src/model/series';
import { ViewModel } from '../../../sim/viewer/src/model/view_model';
import { decision, run } from './run';

const base64 = (array: Float32Array | Uint32Array): string => Buffer.from(array.buffer).toString('base64');

test('data is the same packed and unpacked', async () => {
  const bytes = new Uint8Array(Buffer.from('{"schema":1,"name":"Brücke"}'));
  assert.deepEqual(await jsonOf(bytes), { schema: 1, name: 'Brücke' });
  assert.deepEqual(await jsonOf(new Uint8Array(gzipSync(bytes))), { schema: 1, name: 'Brücke' });
});

test('points and triangles read back; what is cut off or points nowhere is left out', () => {
  assert.deepEqual([...floatsOf(base64(new Float32Array([1, 2, 3, 4.5, 5, 6, 7])))], [1, 2, 3, 4.5, 5, 6]);
  assert.deepEqual([...trianglesOf(base64(new Uint32Array([0, 1, 2, 0, 1, 3])), 3)], [0, 1, 2]);
  assert.equal(floatsOf(undefined).length, 0);
});

test('whatever is missing is empty', () => {
  const model = new ViewModel(normalise({ schema: 1 }));
  assert.deepEqual([model.agents, model.tasks, model.events, model.first_s, model.last_s], [[], [], [], 0, 0]);
  assert.equal(model.mission.known || model.links.known, false);
  const times = sampleTimes(model, 10);
  assert.deepEqual([loadSeries(model, times), disputeSeries(model, times)], [[], [0]]);
});

test('what is no view data is refused, by its schema', () => {
  for (const raw of [null, 3, [], {}, { schema: 2 }]) assert.throws(() => normalise(raw), /view data: schema: .*legal: 1/);
});

test('the auction lasts from the first to the last that is known of it', () => {
  const model = run({ start_s: 0.6, end_s: 0.9, events: [{ t_s: 0.5, kind: 'mission', agent: null, text: '' }, { t_s: 1.1, kind: 'end', agent: null, text: '' }] });
  assert.deepEqual([model.first_s, model.last_s], [0.5, 1.1]);
});

test('64 agents look different, by colour and dashes together', () => {
  for (const dark of [false, true]) {
    const looks = new Set(Array.from({ length: 64 }, (_, slot) => `${lookOf(slot, dark).css} ${lookOf(slot, dark).pattern}`));
    assert.equal(looks.size, 64);
  }
  assert.equal(DASHES.length, PATTERNS);
});

test('series: one value a sample, the last at the end; first bids for everything do not flatten the rest', () => {
  const model = run({ start_s: 0, end_s: 11, decisions: [decision(1, 1, [10, -1, 11, -1, 12, -1]), decision(1.5, 1, [10, -1]), decision(1.6, 2, [11, -1])] });
  const times = sampleTimes(model, 100);
  assert.deepEqual(times, [0, 1, 1.5, 1.6, 11]);
  const series = loadSeries(model, times);
  assert.deepEqual(series, [[0, 6, 2, 2, 2], [0, 0, 0, 2, 2], [0, 0, 0, 0, 0]]);
  assert.equal(usualMost(times, series), 1.15 * 2);
  assert.ok(sampleTimes(model, 2).length <= 4);
});
