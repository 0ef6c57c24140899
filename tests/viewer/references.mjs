// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures held against those that were looked at. `--update` takes what is drawn now for the references.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { load } from './modules.mjs';

const folder = join(dirname(fileURLToPath(import.meta.url)), 'references');
const update = process.env.ARCBID_UPDATE_REFERENCES === '1';
/** Rasterisers round edges differently: of all pixels this share may be another colour. */
const TOLERANCE = 0.015;

/** Of the pixels of two pictures of one size. */
export async function shareOfDifference(one, other) {
  const { PNG } = await load('pngjs');
  const pixelmatch = await load('pixelmatch');
  const a = PNG.sync.read(one), b = PNG.sync.read(other);
  assert.deepEqual([a.width, a.height], [b.width, b.height], 'another size');
  return pixelmatch(a.data, b.data, undefined, a.width, a.height, { threshold: 0.15 }) / (a.width * a.height);
}

export async function compare(name, png) {
  const file = join(folder, `${name}.png`);
  if (update) { writeFileSync(file, png); return; }
  const share = await shareOfDifference(png, readFileSync(file));
  assert.ok(share <= TOLERANCE, `${name}: ${(100 * share).toFixed(2)} % of the picture differ, ${100 * TOLERANCE} % may`);
}
