// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { embed, fixture } from '../fixture.mjs';
import { clickPiece, picture, press, seek, state } from '../page_steps.mjs';
import { compare } from '../references.mjs';
import { bare, made, openMade, openPage, pageFile, SMALL, useBrowser } from './setup.mjs';

useBrowser();

test('the built page has one place for data, and embeds what it is given', () => {
  assert.equal(bare.split('<!--arcbid-data-->').length, 2);
  assert.equal(bare.split(/<\/script/i).length, 2);
});

test('time changes owners, a click explains, events are jumped to', async () => {
  const { page, problems, close } = await openMade();
  assert.deepEqual(await page.evaluate(() => window.arcbid.counts()), { agents: 8, arcs: made.arcs.length, tasks: made.tasks.length });
  assert.ok((await state(page)).owners.every((owner) => owner === -1));

  await seek(page, made.auction.end_s);
  const { winner } = lastTable();
  assert.deepEqual((await state(page)).owners, winner);
  const slider = page.getByRole('slider', { name: 'Auction time' });
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + 0.2 * box.width, box.y + 2);
  await page.evaluate(() => window.arcbid.drawn());
  assert.notDeepEqual((await state(page)).owners, winner);

  await seek(page, made.auction.end_s);
  const first = await clickPiece(page);
  const task = await clickPiece(page, made.tasks.findIndex((one) => one.task === first) + 40);
  assert.ok(task > first, 'another place is another piece');
  assert.equal((await page.textContent('#explanation')).includes(made.explanations[task][0].text), true);
  assert.match(await page.textContent('#piece-facts'), new RegExp(`agent ${winner[made.tasks.findIndex((one) => one.task === task)]}`));

  await page.getByRole('button', { name: /agent 5 killed/ }).first().click();
  await page.evaluate(() => window.arcbid.drawn());
  const death = made.auction.events.find(({ kind }) => kind === 'death');
  assert.equal((await state(page)).t, death.t_s);
  assert.equal((await state(page)).owners.includes(5), false, 'the dead own nothing');
  assert.match(await page.locator('.load.dead').textContent(), /5.*dead/);
  assert.deepEqual(problems, []);
  await close();
});

/** Who has each piece when all is agreed. */
function lastTable() {
  const table = new Map();
  for (const { z } of made.auction.views[0].changes) for (let i = 0; i < z.length; i += 3) table.set(z[i], z[i + 1]);
  return { winner: made.tasks.map(({ task }) => table.get(task)) };
}

test('an agent\'s own view may differ from the fleet\'s, and disputes are counted', async () => {
  const { page, close } = await openMade();
  await seek(page, made.auction.start_s + 0.025);
  const fleet = await state(page);
  assert.ok(fleet.disputes > 0);
  assert.equal(await page.textContent('#disputes'), `${fleet.disputes} pieces disputed`);
  await page.selectOption('#perspective', '8');
  await page.evaluate(() => window.arcbid.drawn());
  assert.notDeepEqual((await state(page)).owners, fleet.owners);
  await seek(page, made.auction.end_s);
  assert.equal(await page.textContent('#disputes'), '');
  await close();
});

test('drones fly at mission time, and links tell their losses', async () => {
  const { page, close } = await openMade();
  const home = (await state(page)).drones;
  await seek(page, 60, 'mission');
  const { drones, track } = await state(page);
  assert.equal(track, 'mission');
  assert.deepEqual(drones[4], home[4], 'who died stays where it was');
  for (const i of [0, 1, 2, 3, 5, 6, 7]) assert.notDeepEqual(drones[i], home[i]);
  await seek(page, 0.72);
  assert.match(await page.textContent('#link-facts'), /^[1-9]\d* of \d+ messages lost, [1-9]\d* links silent$/);
  await close();
});

test('nothing is drawn while nothing moves, and more agents cost no more draw calls', async () => {
  const few = await openMade();
  await seek(few.page, made.auction.end_s);
  const still = await few.page.evaluate(async () => {
    await window.arcbid.drawn();
    const { frames } = window.arcbid.state();
    for (let i = 0; i < 5; i++) await new Promise(requestAnimationFrame);
    return window.arcbid.state().frames - frames;
  });
  assert.equal(still, 0);
  const { drawCalls } = await state(few.page);
  await few.close();
  const many = await openPage(pageFile(embed(bare, fixture({ agents: 24, rows: 12, piece: 10 }))));
  await seek(many.page, 9);
  assert.equal((await state(many.page)).drawCalls, drawCalls);
  assert.ok(drawCalls <= 8, `${drawCalls}`);
  await many.close();
});

test('light and dark look as they did', async () => {
  const { page, close } = await openMade(SMALL);
  await seek(page, 0.645);
  await compare('auction_light', await picture(page));
  await press(page, 't');
  await press(page, 't');
  assert.equal((await state(page)).dark, true);
  await seek(page, 120, 'mission');
  await compare('mission_dark', await picture(page));
  await close();
  const dark = await openMade({ ...SMALL, scheme: 'dark' });
  assert.equal((await state(dark.page)).dark, true, 'as the system has it');
  await dark.close();
});

test('the page can reach nobody else', async () => {
  const { page, close } = await openMade();
  const directive = await page.evaluate(() => new Promise((done) => {
    document.addEventListener('securitypolicyviolation', (event) => done(event.effectiveDirective));
    fetch('http://127.0.0.1:9/').catch(() => undefined);
    setTimeout(done, 20000, 'nothing forbade it');
  }));
  assert.equal(directive, 'connect-src');
  await close();
});

test('damaged data, no data and hardly any data are told apart', async () => {
  const said = async (html) => {
    const { page, problems, close } = await openPage(pageFile(html));
    const text = await page.evaluate(() => (document.getElementById('message').hidden ? '' : document.getElementById('message').textContent));
    await close();
    return { text, problems };
  };
  assert.match((await said(bare)).text, /holds no run/);
  assert.match((await said(embed(bare, { schema: 7 }))).text, /schema: 7; legal: 1/);
  assert.deepEqual(await said(embed(bare, { schema: 1 })), { text: '', problems: [] });
});
