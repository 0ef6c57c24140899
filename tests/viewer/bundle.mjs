// SPDX-License-Identifier: GPL-3.0-or-later
// TypeScript for a node that cannot read it.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { load, modules } from './modules.mjs';

/** Each entry as a file that node runs, in a directory of its own that goes with the process. */
export async function bundle(entries) {
  const esbuild = await load('esbuild');
  const outdir = mkdtempSync(join(tmpdir(), 'arcbid-viewer-'));
  process.on('exit', () => rmSync(outdir, { recursive: true, force: true }));
  esbuild.buildSync({
    entryPoints: entries, bundle: true, platform: 'node', format: 'esm', target: 'node18', outdir, outExtension: { '.js': '.mjs' },
    outbase: '/', entryNames: '[name]', nodePaths: [modules], sourcemap: 'inline', logLevel: 'error',
  });
  return entries.map((entry) => join(outdir, basename(entry).replace(/\.ts$/, '.mjs')));
}
