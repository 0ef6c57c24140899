// SPDX-License-Identifier: GPL-3.0-or-later
// Where the viewer's packages are: $ARCBID_NODE_MODULES, a build directory's, or those beside the sources.
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const places = [process.env.ARCBID_NODE_MODULES, join(root, 'build', 'viewer', 'node_modules'), join(root, 'sim', 'viewer', 'node_modules')];

export const viewer = join(root, 'sim', 'viewer');
export const modules = places.find((place) => place && existsSync(join(place, 'playwright-core')));

export async function load(name) {
  if (!modules) throw new Error('the viewer\'s packages are nowhere: build the target "viewer", or set ARCBID_NODE_MODULES');
  const module = await import(pathToFileURL(createRequire(join(modules, 'x.js')).resolve(name)));
  return module.default ?? module;
}
