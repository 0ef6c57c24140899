// SPDX-License-Identifier: GPL-3.0-or-later
// Runs model/*.test.ts.
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bundle } from './bundle.mjs';
import { skipWithoutPackages } from './skip.mjs';

skipWithoutPackages();
const here = join(dirname(fileURLToPath(import.meta.url)), 'model');
const tests = await bundle(readdirSync(here).filter((name) => name.endsWith('.test.ts')).map((name) => join(here, name)));
process.exitCode = spawnSync(process.execPath, ['--enable-source-maps', '--test', ...tests], { stdio: 'inherit' }).status ?? 1;
