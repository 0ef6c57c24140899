// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { knownAt, serve } from '../live_server.mjs';
import { press, state } from '../page_steps.mjs';
import { bare, made, openPage, useBrowser } from './setup.mjs';

useBrowser();

test('a live run is followed at its end, and left alone elsewhere', async (t) => {
  const server = await serve(bare, knownAt(made, 0.7));
  t.after(() => server.close());
  const { page, problems, close } = await openPage(server.url);
  const live = (text) => page.waitForFunction((wanted) => document.getElementById('live').textContent.includes(wanted), text);
  const until = (end) => page.waitForFunction((wanted) => window.arcbid.span('auction').to === wanted, end);
  await live('live');
  assert.equal((await state(page)).t, 0.7, 'begins at the end');

  await press(page, 'n');
  await press(page, 'd');
  const where = await page.evaluate(() => window.arcbid.find(0));
  server.update(knownAt(made, 0.85), false);
  await until(0.85);
  await page.evaluate(() => window.arcbid.drawn());
  const followed = await state(page);
  assert.deepEqual([followed.t, followed.task], [0.85, made.tasks[0].task]);
  assert.deepEqual(await page.evaluate(() => window.arcbid.find(0)), where, 'the camera stays');

  await press(page, '[');
  const place = (await state(page)).t;
  assert.ok(place < 0.85);
  server.update({ ...made, live: true }, true);
  await until(made.auction.end_s);
  assert.equal((await state(page)).t, place, 'who looks elsewhere is left alone');
  await live('ended');
  await press(page, '2');
  assert.equal((await state(page)).track, 'mission');

  assert.deepEqual(problems, []);
  assert.deepEqual([...new Set(server.paths)].sort(), ['/', '/data', '/updates']);
  await close();
});

test('a lost connection is said', async (t) => {
  const server = await serve(bare, knownAt(made, 0.7));
  t.after(() => server.close());
  const { page, close } = await openPage(server.url);
  await page.waitForFunction(() => document.getElementById('live').textContent.includes('live'));
  await server.close();
  await page.waitForFunction(() => document.getElementById('live').textContent.includes('lost'));
  assert.equal((await state(page)).t, 0.7, 'what was heard stays');
  await close();
});
