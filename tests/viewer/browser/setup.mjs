// SPDX-License-Identifier: GPL-3.0-or-later
// One browser for a file of tests, and the built page with a made run in it.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { launch, open } from '../browser.mjs';
import { embed, fixture } from '../fixture.mjs';

export const bare = readFileSync(process.env.ARCBID_VIEWER_PAGE, 'utf8');
/** The stage is then 640 by 400: the size of the references. */
export const SMALL = { width: 640 + 372, height: 400 + 96 };

let browser, folder;

export function useBrowser() {
  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'arcbid-browser-'));
    browser = await launch();
  });
  after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true, force: true });
  });
}

export const openPage = (what, options) => open(browser, what, options);

export function pageFile(html, name = 'page.html') {
  const file = join(folder, name);
  writeFileSync(file, html);
  return file;
}

export const made = fixture();
export const openMade = (options) => openPage(pageFile(embed(bare, made)), options);
