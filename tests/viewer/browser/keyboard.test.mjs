// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { press, seek, state } from '../page_steps.mjs';
import { made, openMade, useBrowser } from './setup.mjs';

useBrowser();
const { auction } = made;

test('time goes by keys', async () => {
  const { page, problems, close } = await openMade();
  const at = async () => (await state(page)).t;
  await press(page, 'End');
  assert.equal(await at(), auction.end_s);
  await press(page, 'Home');
  assert.equal(await at(), auction.events[0].t_s);
  await press(page, ']');
  assert.equal(await at(), auction.events[1].t_s);
  await press(page, '[');
  assert.equal(await at(), auction.events[0].t_s);
  const moments = [...new Set([...auction.decisions, ...auction.views.flatMap((view) => view.changes)].map(({ t_s }) => t_s))].sort((a, b) => a - b);
  await press(page, 'ArrowRight');
  assert.equal(await at(), moments[0]);
  await press(page, 'Shift+ArrowRight');
  assert.equal(await at(), moments[10]);
  await press(page, 'ArrowLeft');
  assert.equal(await at(), moments[9]);
  await press(page, '2');
  assert.equal((await state(page)).track, 'mission');
  await press(page, 'ArrowRight');
  assert.equal(await at(), 1);
  await press(page, '1');
  assert.equal((await state(page)).track, 'auction');
  assert.deepEqual(problems, []);
  await close();
});

test('space plays on into the mission, and stops', async () => {
  const { page, close } = await openMade();
  await seek(page, auction.end_s - 0.001);
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.arcbid.state().track === 'mission' && window.arcbid.state().t > 0);
  await page.keyboard.press('Space');
  assert.equal((await state(page)).playing, false);
  const { t } = await state(page);
  await press(page, '1');
  await press(page, '2');
  assert.equal((await state(page)).t, t);
  await close();
});

test('pieces, views, lists and the sheet of keys are reached without a mouse', async () => {
  const { page, close } = await openMade();
  await press(page, 'End');
  await press(page, 'n');
  await press(page, 'n');
  assert.equal((await state(page)).task, made.tasks[1].task);
  assert.ok((await page.textContent('#explanation')).includes(made.explanations[made.tasks[1].task][0].text));
  await press(page, 'Escape');
  assert.equal((await state(page)).task, null);
  await press(page, 'v');
  assert.equal((await state(page)).perspective, 1);
  await press(page, 'Shift+V');
  assert.equal((await state(page)).perspective, 'fleet');

  await page.focus('#events button');
  await press(page, 'ArrowDown');
  await press(page, 'ArrowDown');
  await press(page, 'Enter');
  assert.equal((await state(page)).t, auction.events[2].t_s);

  await page.focus('.load');
  await press(page, 'Enter');
  assert.equal((await state(page)).agent, 1);

  await page.keyboard.press('?');
  assert.equal(await page.isVisible('#help'), true);
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#help'), false);
  await close();
});

test('Tab goes through everything once, and where it is can be seen', async () => {
  const { page, close } = await openMade();
  const seen = [];
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    const here = await page.evaluate(() => {
      const element = document.activeElement;
      const name = element.getAttribute('aria-label') ?? element.labels?.[0]?.textContent ?? element.textContent;
      return { tag: element.tagName, id: element.id, role: element.getAttribute('role'), named: (name ?? '').trim() !== '', outline: getComputedStyle(element).outlineStyle };
    });
    if (here.tag === 'BODY') break;
    seen.push(here);
  }
  assert.deepEqual(seen.filter(({ named, outline }) => !named || outline === 'none'), []);
  const order = seen.map(({ id }) => id).filter(Boolean);
  assert.deepEqual(order.filter((id) => ['scene', 'perspective', 'theme', 'piece', 'play', 'rate'].includes(id)), ['scene', 'perspective', 'theme', 'piece', 'play', 'rate']);
  assert.equal(seen.filter(({ role }) => role === 'slider').length, 2);
  await close();
});
