// SPDX-License-Identifier: GPL-3.0-or-later
// node check_beliefs.mjs DATA.json EXPECT.json: data packed or not; EXPECT holds
// [{"agent":1,"t_s":0.7,"winners":[by task, -1 nobody],"bids":[by task, null for nobody's]}, …].
import { spawnSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bundle } from './bundle.mjs';
import { skipWithoutPackages } from './skip.mjs';

if (process.argv.length !== 4) {
  console.error('check_beliefs.mjs: two file names are needed: DATA.json EXPECT.json');
  process.exit(2);
}
skipWithoutPackages();
const [script] = await bundle([join(dirname(fileURLToPath(import.meta.url)), 'check_beliefs.ts')]);
process.exitCode = spawnSync(process.execPath, [script, ...process.argv.slice(2)], { stdio: 'inherit' }).status ?? 1;
