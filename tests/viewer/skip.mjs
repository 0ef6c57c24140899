// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be tested on this machine is said and not counted as tested: CTest knows 77.
import { chromium } from './browser.mjs';
import { modules } from './modules.mjs';

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

export function skipWithoutPackages() {
  if (!modules) skip('the viewer\'s packages were not fetched');
}

export function skipWithoutBrowser() {
  skipWithoutPackages();
  if (!chromium) skip('chromium is not installed');
}
