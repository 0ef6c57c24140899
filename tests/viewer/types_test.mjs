// SPDX-License-Identifier: GPL-3.0-or-later
// tsc on the viewer and its tests, with packages from wherever they are.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { modules, viewer } from './modules.mjs';
import { skipWithoutPackages } from './skip.mjs';

skipWithoutPackages();
const here = dirname(fileURLToPath(import.meta.url));
const work = mkdtempSync(join(tmpdir(), 'arcbid-types-'));
process.on('exit', () => rmSync(work, { recursive: true, force: true }));
const types = join(modules, '@types');
const config = (include, uses) => ({
  extends: join(viewer, 'tsconfig.json'),
  compilerOptions: { paths: { '*': [join(types, '*'), join(modules, '*')] }, typeRoots: [types], types: uses },
  include,
});
// The page itself must get by without node's types.
const configs = { page: config([join(viewer, 'src')], []), tests: config([join(here, 'model')], ['node']) };
for (const [name, content] of Object.entries(configs)) {
  const file = join(work, `${name}.json`);
  writeFileSync(file, JSON.stringify(content));
  const { status } = spawnSync(process.execPath, [join(modules, 'typescript', 'bin', 'tsc'), '--noEmit', '-p', file], { stdio: 'inherit' });
  if (status !== 0) process.exitCode = 1;
}
