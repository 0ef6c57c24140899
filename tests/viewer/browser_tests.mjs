// SPDX-License-Identifier: GPL-3.0-or-later
// node browser_tests.mjs PAGE.html [--update]: runs browser/*.test.mjs on the built page.
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { skipWithoutBrowser } from './skip.mjs';

const [page, ...options] = process.argv.slice(2);
if (!page) {
  console.error('browser_tests.mjs: one file name is needed: PAGE.html');
  process.exit(2);
}
skipWithoutBrowser();
if (!existsSync(page)) {
  console.error(`${page}: is not there; build the target "viewer"`);
  process.exit(1);
}
const here = join(dirname(fileURLToPath(import.meta.url)), 'browser');
const env = { ...process.env, ARCBID_VIEWER_PAGE: resolve(page), ARCBID_UPDATE_REFERENCES: options.includes('--update') ? '1' : '0' };
// One after the other: each has a software GPU to itself.
for (const name of readdirSync(here).filter((file) => file.endsWith('.test.mjs')).sort())
  if (spawnSync(process.execPath, ['--test', join(here, name)], { stdio: 'inherit', env }).status !== 0) process.exitCode = 1;
