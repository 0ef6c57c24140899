// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { embed, fixture } from '../fixture.mjs';
import { drawn, picture, press, seek, state } from '../page_steps.mjs';
import { compare, shareOfDifference } from '../references.mjs';
import { bare, made, openMade, openPage, pageFile, SMALL, useBrowser } from './setup.mjs';

useBrowser();
const certified = fixture({ samples: 12000 });
const { coverage } = certified;
const openCertified = (options, data = certified) => openPage(pageFile(embed(bare, data), 'certified.html'), options);
const near = coverage.clearance[1];

/** What is looked at; the camera's own arithmetic errs in the last digits. */
async function lookedAt(page) {
  const { mark, target } = await state(page);
  return [mark, target.map((value) => Number(value.toFixed(6)))];
}
const placeOf = ({ agent, nearest }) => [agent, nearest.at_m.map((value) => Number(value.toFixed(6)))];

test('coverage and redundancy colour the structure, and legends say what they mean', async () => {
  const { page, problems, close } = await openCertified(SMALL);
  await seek(page, certified.auction.end_s);
  const plain = await picture(page);
  assert.equal(await page.isVisible('#legend'), false);
  const { drawCalls } = await state(page);

  await page.selectOption('#colouring', 'coverage');
  const covered = await picture(page);
  assert.ok((await shareOfDifference(plain, covered)) > 0.05);
  await compare('coverage_light', covered);
  assert.equal((await state(page)).drawCalls, drawCalls, 'samples take the place of the cloud');
  const rows = await page.locator('#legend button').allTextContents();
  const { classes } = coverage.samples;
  const beyond = classes[5] + classes[6] + classes[7];
  assert.deepEqual(rows, [
    ['covered', classes[0]], ['visible but missed', classes[1]], ['visible, not assigned', classes[2]], ['invisible: too close to the ground', classes[3]],
    ['invisible: unreachable', classes[4]], ['invisible: beyond the sensor\'s limits', beyond], ['invisible: occluded', classes[8]],
  ].map(([name, count]) => name + count.toLocaleString('en')));

  await page.getByRole('button', { name: 'visible but missed' }).click();
  assert.equal(await page.locator('#legend button[aria-pressed="true"]').count(), 1);
  assert.ok((await shareOfDifference(covered, await picture(page))) > 0.05, 'the others are faint');

  await page.selectOption('#colouring', 'redundancy');
  assert.equal((await state(page)).only, null);
  assert.ok((await shareOfDifference(covered, await picture(page))) > 0.05);
  assert.match((await page.locator('#legend button').allTextContents())[0], /^not covered/);
  await press(page, 't');
  await press(page, 't');
  await compare('redundancy_dark', await picture(page));
  assert.deepEqual(problems, []);
  await close();
});

test('colours and clearances go by keys alone', async () => {
  const { page, close } = await openCertified();
  for (const colouring of ['coverage', 'redundancy', 'plain', 'coverage']) {
    await press(page, 'c');
    assert.equal((await state(page)).colouring, colouring);
    assert.equal(await page.inputValue('#colouring'), colouring);
  }
  await press(page, 'Shift+C');
  assert.equal((await state(page)).colouring, 'plain');
  const first = coverage.clearance[0], last = coverage.clearance.at(-2);
  await press(page, 'm');
  assert.deepEqual(await lookedAt(page), placeOf(first));
  await press(page, 'Shift+M');
  assert.equal((await state(page)).mark, last.agent, 'who did not fly has no place to go to');
  await press(page, 'Escape');
  assert.equal((await state(page)).mark, null);
  await page.focus('#clearances button');
  await press(page, 'Enter');
  assert.equal((await state(page)).mark, first.agent);
  await press(page, 'c');
  await page.focus('#legend button');
  await press(page, 'Enter');
  assert.equal((await state(page)).only, 0);
  await close();
});

test('a click on a clearance, in the list or in the scene, goes there', async () => {
  const { page, close } = await openCertified();
  await page.locator('#clearances button', { hasText: '1.50 m < 2 m' }).click();
  await drawn(page);
  assert.deepEqual(await lookedAt(page), placeOf(near));
  assert.equal(await page.getAttribute(`#clearances button[data-agent="${near.agent}"]`, 'aria-pressed'), 'true');
  assert.deepEqual(await page.locator('#clearances .near').allTextContents(), [`agent ${near.agent}1.50 m < 2 mleg 2`], 'only that one is too near');

  await press(page, 'Escape');
  await press(page, 'f');
  assert.notDeepEqual(await lookedAt(page), placeOf(near));
  await press(page, 'c');
  const at = await page.evaluate((agent) => window.arcbid.findMark(agent), near.agent);
  await page.mouse.click(at.x, at.y);
  await drawn(page);
  assert.deepEqual(await lookedAt(page), placeOf(near));
  await close();
});

test('the panel has the figures; without a certificate nothing of it is there', async () => {
  const { page, close } = await openCertified();
  const figures = await page.textContent('#coverage-figures');
  const count = (value) => value.toLocaleString('en');
  assert.ok(figures.includes(`${count(coverage.covered_visible_samples)} of ${count(coverage.visible_samples)}`), figures);
  assert.ok(figures.includes(`${count(coverage.covered_samples)} of ${count(coverage.surface_samples)}`), figures);
  assert.match(figures, /spacing 0\.70 m.*0\.500 m per m²/);
  for (const { reason, count: of } of coverage.uncovered) assert.ok((await page.textContent('#uncovered')).includes(reason + count(of)), reason);
  await close();

  const without = await openMade();
  for (const place of ['#coverage-figures', '#colouring', '#legend']) assert.equal(await without.page.isVisible(place), false, place);
  await press(without.page, 'c');
  await press(without.page, 'm');
  assert.equal((await state(without.page)).colouring, 'plain');
  assert.deepEqual(without.problems, []);
  await without.close();
});

test('a damaged certificate is one line, and the rest works', async () => {
  const { page, problems, close } = await openCertified({}, { ...made, coverage: { problem: 'certificate.json: schema is 2, must be 1' } });
  assert.equal(await page.textContent('#coverage-problem'), 'certificate.json: schema is 2, must be 1');
  assert.equal(await page.isVisible('#coverage-problem'), true);
  assert.equal(await page.isVisible('#colouring'), false);
  await seek(page, made.auction.end_s);
  assert.ok((await state(page)).owners.every((owner) => owner >= 0));
  assert.deepEqual(problems, []);
  await close();
});
