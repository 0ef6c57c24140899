// SPDX-License-Identifier: GPL-3.0-or-later
// node picture.mjs PAGE.html OUT.png [--time S] [--mission S] [--width W] [--height H] [--task T] [--dark]
import { parseArgs } from 'node:util';
import { launch, open } from './browser.mjs';

const text = { type: 'string' };
const { values, positionals } = parseArgs({
  allowPositionals: true, options: { time: text, mission: text, width: text, height: text, task: text, dark: { type: 'boolean' } },
});
const [from, out] = positionals;
if (!from || !out) {
  console.error('picture.mjs: two file names are needed: PAGE.html OUT.png');
  process.exit(2);
}
const browser = await launch();
try {
  const { page, problems } = await open(browser, from, {
    width: Number(values.width ?? 1600), height: Number(values.height ?? 900), scheme: values.dark ? 'dark' : 'light',
  });
  if (values.time !== undefined) await page.evaluate((t) => window.arcbid.seek(t, 'auction'), Number(values.time));
  if (values.mission !== undefined) await page.evaluate((t) => window.arcbid.seek(t, 'mission'), Number(values.mission));
  if (values.task !== undefined) await page.selectOption('#piece', values.task);
  await page.evaluate(() => window.arcbid.drawn());
  await page.screenshot({ path: out });
  for (const problem of problems) console.error(problem);
  process.exitCode = problems.length > 0 ? 1 : 0;
} finally {
  await browser.close();
}
