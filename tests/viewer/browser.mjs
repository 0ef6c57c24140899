// SPDX-License-Identifier: GPL-3.0-or-later
// A headless Chromium on a software GPU, and a page in it that keeps account of what it must not do.
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { load } from './modules.mjs';

const FLAGS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];
/** A software GPU on a busy machine takes its time: these are limits, not waits. */
export const PATIENCE_MS = 120000;

export const chromium = process.env.ARCBID_CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((file) => existsSync(file));

export async function launch() {
  const playwright = await load('playwright-core');
  return playwright.chromium.launch({ executablePath: chromium, args: FLAGS, timeout: PATIENCE_MS });
}

/** Opens a file or an address; `before` runs ahead of the page's own scripts; `problems` fills with console errors and with requests beyond the page's own place. */
export async function open(browser, what, { width = 1280, height = 800, scheme = 'light', before } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: scheme, deviceScaleFactor: 1 });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  if (before) await page.addInitScript(before);
  const url = what.startsWith('http') ? what : pathToFileURL(what).href;
  const problems = [];
  page.on('console', (message) => {
    // What the driver says of its own speed is no fault of the page.
    if (message.type() === 'error' || (message.type() === 'warning' && !/GL Driver Message|GPU stall/.test(message.text())))
      problems.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => problems.push(`error: ${error.message}`));
  page.on('request', (request) => {
    const own = request.url().startsWith('data:') || request.url() === url || (url.startsWith('http') && request.url().startsWith(url));
    if (!own) problems.push(`request: ${request.url()}`);
  });
  await page.goto(url);
  await page.waitForFunction(() => document.documentElement.dataset.ready !== undefined);
  if ((await page.evaluate(() => document.documentElement.dataset.ready)) === 'yes') await page.evaluate(() => window.arcbid.drawn());
  return { page, problems, close: () => context.close() };
}
