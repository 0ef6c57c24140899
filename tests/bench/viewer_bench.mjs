// SPDX-License-Identifier: GPL-3.0-or-later
// node tests/bench/viewer_bench.mjs [PAGE.html] [--points N] [--agents N] [--seconds S]
// What a frame of the viewer costs while a made run plays, in a headless Chromium without a GPU.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { launch, open } from '../viewer/browser.mjs';
import { embed, fixture } from '../viewer/fixture.mjs';
import { skipWithoutBrowser } from '../viewer/skip.mjs';

const FRAMES_PER_S = 30;
const LIMIT_MS = 5;  // of CPU a frame, not drawn
const number = (value) => ({ type: 'string', default: value });
const { values, positionals } = parseArgs({
  allowPositionals: true, options: { points: number('200000'), agents: number('64'), seconds: number('10') },
});
skipWithoutBrowser();

/** Runs in the page before its own scripts: counts what is drawn, and can run frames without a screen. */
function takeFrames() {
  const account = { draws: true, calls: 0, vertices: 0 };
  const places = { drawArrays: [2, 0], drawElements: [1, 0], drawArraysInstanced: [2, 3], drawElementsInstanced: [1, 4] };
  const gl = WebGL2RenderingContext.prototype;
  for (const [name, [count, instances]] of Object.entries(places)) {
    const draw = gl[name];
    gl[name] = function (...args) {
      account.calls++;
      account.vertices += args[count] * (instances ? args[instances] : 1);
      if (account.draws) draw.apply(this, args);
    };
  }
  const request = window.requestAnimationFrame.bind(window);
  let waiting = null, now = performance.now();
  window.requestAnimationFrame = (frame) => (waiting ? waiting.push(frame) : request(frame));
  window.takeFrames = {
    account,
    /** From now on frames come by run() only. */
    hold: () => { waiting = []; },
    run: (count, every_ms) => {
      for (let k = 0; k < count; k++) {
        now += every_ms;
        for (const frame of waiting.splice(0)) frame(now);
      }
    },
  };
}

async function begin(page, track) {
  const span = await page.evaluate((name) => window.arcbid.span(name), track);
  await page.evaluate(([t, name]) => window.arcbid.seek(t, name), [span.from, track]);
  await page.keyboard.press('Space');
}

/** As fast as a GPU made of CPU goes. */
async function drawn(page, track, seconds) {
  await begin(page, track);
  const count = () => page.evaluate(() => [performance.now(), Number(document.documentElement.dataset.frames)]);
  const [from_ms, before] = await count();
  await page.waitForTimeout(1000 * seconds);
  const [to_ms, after] = await count();
  await page.keyboard.press('Space');
  console.log(`${track}, drawn by software: ${((1000 * (after - before)) / (to_ms - from_ms)).toFixed(1)} frames a second`);
}

/** The CPU of the page's own thread, for frames at an even pace of which nothing is drawn; other programs do not count. */
async function calculated(page, track, seconds) {
  await begin(page, track);
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Performance.enable', { timeDomain: 'threadTicks' });
  const busy_s = async () => (await cdp.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value;
  const run = (count) => page.evaluate(([n, ms]) => window.takeFrames.run(n, ms), [count, 1000 / FRAMES_PER_S]);
  await page.evaluate(() => { window.takeFrames.hold(); window.takeFrames.account.draws = false; });
  await page.waitForTimeout(3000);  // a frame may still be on its way
  await run(2 * FRAMES_PER_S);  // the compiler has its say
  const frames = Math.round(seconds * FRAMES_PER_S);
  await page.evaluate(() => Object.assign(window.takeFrames.account, { calls: 0, vertices: 0 }));
  const shown = await page.evaluate(() => Number(document.documentElement.dataset.frames));
  const from_s = await busy_s();
  await run(frames);
  const took_s = (await busy_s()) - from_s;
  const { calls, vertices, now } = await page.evaluate(() => ({
    ...window.takeFrames.account, now: Number(document.documentElement.dataset.frames),
  }));
  if (now - shown < frames) throw new Error(`${now - shown} frames of ${frames} were made: the run was over before`);
  const frame_ms = (1000 * took_s) / frames;
  console.log(`${track}, not drawn: ${frame_ms.toFixed(2)} ms of CPU a frame, ` +
    `${(calls / frames).toFixed(1)} draw calls, ${Math.round(vertices / frames)} vertices (${frames} frames)`);
  if (frame_ms <= LIMIT_MS) return;
  console.error(`${track}, not drawn: more than ${LIMIT_MS} ms a frame`);
  process.exitCode = 1;
}

const folder = mkdtempSync(join(tmpdir(), 'arcbid-viewer-bench-'));
const browser = await launch();
try {
  const data = fixture({ points: Number(values.points), agents: Number(values.agents), rows: 12, piece: 5 });
  const file = join(folder, 'run.html');
  writeFileSync(file, embed(readFileSync(positionals[0] ?? 'build/share/viewer.html', 'utf8'), data));
  console.log(`${values.points} points, ${values.agents} agents, ${data.tasks.length} pieces, ${data.mission.routes.length} routes`);
  for (const track of ['auction', 'mission']) for (const measure of [drawn, calculated]) {
    const { page, problems, close } = await open(browser, file, { before: takeFrames });
    await measure(page, track, Number(values.seconds));
    for (const problem of problems) console.error(problem);
    if (problems.length > 0) process.exitCode = 1;
    await close();
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
