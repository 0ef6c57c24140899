// SPDX-License-Identifier: GPL-3.0-or-later
// node report_test.mjs BUILD SOURCE: a real run, its report in a real browser, and the same run served.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { get } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';

const [build, source] = process.argv.slice(2);
const arcbid = join(build, 'bin/arcbid');
if (!existsSync(join(build, 'share/viewer.html'))) {
  console.log('skipped: the viewer was not built');
  process.exit(77);
}
const folder = mkdtempSync(join(tmpdir(), 'arcbid-report-'));
const run = join(folder, 'run');

function fail(why) {
  throw new Error(why);
}

/** The address that `arcbid view` prints first. */
function addressOf(server) {
  return new Promise((resolve, reject) => {
    let said = '';
    server.stdout.on('data', (bytes) => {
      said += bytes;
      const address = /http:\/\/127\.0\.0\.1:\d+\//.exec(said);
      if (address) resolve(address[0]);
    });
    server.on('exit', (code) => reject(new Error(`arcbid view ended with ${code}: ${said}`)));
  });
}

function statusOf(address, headers) {
  return new Promise((resolve, reject) => {
    get(`${address}data`, { headers }, (answer) => {
      answer.resume();
      resolve(answer.statusCode);
    }).on('error', reject);
  });
}

async function served() {
  const server = spawn('timeout', ['60', arcbid, 'view', run], { stdio: ['ignore', 'pipe', 'inherit'] });
  try {
    const address = await addressOf(server);
    const page = await (await fetch(address)).text();
    if (!page.includes('<!--arcbid-data-->')) fail('the page that is served has a run in it');
    const data = await (await fetch(`${address}data`)).json();
    if (data.agents.length !== 4 || data.live !== false) fail(`the data are not the run's: ${data.agents.length} agents`);
    const updates = await fetch(`${address}updates`);
    const first = new TextDecoder().decode((await updates.body.getReader().read()).value);
    if (first !== 'data: {"version": 1, "ended": true}\n\n') fail(`the first update is ${JSON.stringify(first)}`);
    if ((await fetch(`${address}logs`)).status !== 404) fail('more is served than the viewer needs');
    const port = new URL(address).port;
    for (const headers of [{ Host: `elsewhere.example:${port}` }, { Host: `127.0.0.1:${port}`, Origin: 'http://elsewhere.example' }])
      if ((await statusOf(address, headers)) !== 403) fail(`a request from elsewhere is answered: ${JSON.stringify(headers)}`);
  } finally {
    server.kill();
  }
}

try {
  execFileSync('timeout', ['60', arcbid, 'run', join(source, 'configs/demo.yaml'), '--out', run, '--report'], { stdio: 'pipe' });
  const result = JSON.parse(readFileSync(join(run, 'result.json'), 'utf8'));
  const html = readFileSync(join(run, 'report.html'), 'utf8');
  const packed = /<script id="arcbid-data" type="application\/gzip-base64">([^<]*)</.exec(html)[1];
  const data = JSON.parse(gunzipSync(Buffer.from(packed, 'base64')));
  if (data.arcs.length !== result.arcs || data.tasks.length !== result.tasks) fail('the report has other arcs or tasks than the run');
  const check = spawnSync(process.execPath, [join(source, 'tests/viewer/check_page.mjs'), join(run, 'report.html')], { stdio: 'inherit' });
  if (check.status !== 0 && check.status !== 77) fail('the report does not stand up to a browser');
  await served();
  // As a launcher that was killed leaves it: there is more to see, but nothing to wait for.
  rmSync(join(run, 'result.json'));
  await served();
  process.exitCode = check.status;
} finally {
  rmSync(folder, { recursive: true });
}
