// SPDX-License-Identifier: GPL-3.0-or-later
// node check_page.mjs PAGE.html [--expect EXPECT.json]: the page loads and asks nobody for anything, its
// counts are those of EXPECT ({"agents":4,"arcs":32,"tasks":71}, each optional), time changes owners, a
// click on an arc explains it. Exit code 1 with one line that names what is wrong.
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { launch, open } from './browser.mjs';
import { clickPiece, mostOwned } from './page_steps.mjs';
import { skipWithoutBrowser } from './skip.mjs';

const { values, positionals } = parseArgs({ allowPositionals: true, options: { expect: { type: 'string' } } });
if (positionals.length !== 1) {
  console.error('check_page.mjs: one file name is needed: PAGE.html');
  process.exit(2);
}
skipWithoutBrowser();

function expect(holds, what) {
  if (!holds) throw new Error(what);
}

async function check(page, problems) {
  const ready = await page.evaluate(() => document.documentElement.dataset.ready);
  expect(ready === 'yes', `the page did not load: ${await page.textContent('#message')}`);
  const counts = await page.evaluate(() => window.arcbid.counts());
  const wanted = values.expect ? JSON.parse(readFileSync(values.expect, 'utf8')) : {};
  for (const [what, count] of Object.entries(wanted))
    expect(counts[what] === count, `the page has ${counts[what]} ${what}, expected ${count}`);
  await page.evaluate(() => window.arcbid.seek(window.arcbid.span('auction').from, 'auction'));
  const before = await mostOwned(page);
  await page.evaluate(() => window.arcbid.seek(window.arcbid.span('auction').to, 'auction'));
  const after = await mostOwned(page);
  expect(after.owned > before.owned, `of ${counts.tasks} pieces ${before.owned} had owners at the begin and ${after.owned} at the end`);
  const task = await clickPiece(page);
  expect(task !== undefined, 'no piece could be clicked');
  const told = await page.textContent('#explanation');
  expect(/agent \d/.test(told), `piece ${task} is explained as "${told}"`);
  expect(problems.length === 0, problems[0]);
  console.log(`${positionals[0]}: ${counts.agents} agents, ${counts.arcs} arcs, ${counts.tasks} pieces; owners change, piece ${task} is explained`);
}

const browser = await launch();
try {
  const { page, problems } = await open(browser, positionals[0]);
  await check(page, problems);
} catch (problem) {
  console.error(`${positionals[0]}: ${problem.message.split('\n')[0]}`);
  process.exitCode = 1;
} finally {
  await browser.close();
}
