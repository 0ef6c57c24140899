// SPDX-License-Identifier: GPL-3.0-or-later
// node build.mjs [OUTFILE]: everything in one html file. Packages are looked for beside this file,
// then in $ARCBID_NODE_MODULES.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const MARK = '<!--arcbid-data-->';
const here = dirname(fileURLToPath(import.meta.url));
const modules = process.env.ARCBID_NODE_MODULES ?? join(here, 'node_modules');
const esbuild = createRequire(join(modules, 'x.js'))('esbuild');
const out = resolve(process.argv[2] ?? join(here, 'dist', 'viewer.html'));

function bundle(entry) {
  const { outputFiles } = esbuild.buildSync({
    entryPoints: [join(here, 'src', entry)], bundle: true, minify: true, write: false, format: 'iife',
    target: ['es2022'], nodePaths: [modules], legalComments: 'none', charset: 'utf8', logLevel: 'error',
  });
  return outputFiles[0].text.trim();
}

// The policy names the two inline blocks by their digests: nothing else may run or style the page.
const digest = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

const script = bundle('main.ts').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const style = bundle('style.css');
const policy = [
  "default-src 'none'", `script-src ${digest(script)}`, `style-src ${digest(style)}`, 'img-src data:', "connect-src 'self'",
  "base-uri 'none'", "form-action 'none'",
].join('; ');

const parts = { CSP: policy, STYLE: style, SCRIPT: script };
const page = readFileSync(join(here, 'src', 'page.html'), 'utf8').replace(/@(CSP|STYLE|SCRIPT)@/g, (_, part) => parts[part]);
if (page.split(MARK).length !== 2) throw new Error(`the page must hold ${MARK} exactly once`);
if (/<\/script/i.test(script) || /<\/style/i.test(style)) throw new Error('a block would end before its end');
mkdirSync(dirname(out), { recursive: true });
writeFileSync(`${out}.part`, page);
renameSync(`${out}.part`, out);
