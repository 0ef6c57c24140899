// SPDX-License-Identifier: GPL-3.0-or-later
// View data of a made run, seeded: the same arguments give the same bytes.
import { gzipSync } from 'node:zlib';
import { auction } from './auction.mjs';
import { bridgeArcs, bridgePoints, distance, pieces, vertex } from './bridge.mjs';
import { coverage } from './coverage.mjs';
import { seeded } from './random.mjs';

const base64 = (array) => Buffer.from(array.buffer).toString('base64');

function fleet(count) {
  const home = (i) => [(120 * (i + 0.5)) / count, i % 2 ? 24 : -24, 0];
  return Array.from({ length: count }, (_, i) => ({ agent: i + 1, home: home(i), speed_mps: 2 }));
}

/** From home through the won pieces, nearest end first, and back. */
function route(agent, won) {
  const line = [...agent.home], at_s = [0], arc = [];
  const fly = (to, along) => {
    at_s.push(at_s[at_s.length - 1] + distance(line.slice(-3), to) / agent.speed_mps);
    line.push(...to);
    arc.push(along);
  };
  const left = new Set(won);
  while (left.size > 0) {
    const here = line.slice(-3);
    let best, near = Infinity;
    for (const task of left) for (const back of [false, true]) {
      const far = distance(here, back ? task.line.slice(-3) : task.line.slice(0, 3));
      if (far < near) { near = far; best = { task, back }; }
    }
    left.delete(best.task);
    const count = best.task.line.length / 3;
    for (let k = 0; k < count; k++) fly(vertex(best.task.line, best.back ? count - 1 - k : k), k === 0 ? -1 : best.task.arc);
  }
  fly(agent.home, -1);
  const time_s = at_s[at_s.length - 1];
  return { agent: agent.agent, length_m: time_s * agent.speed_mps, time_s, line, at_s, arc };
}

export function fixture({ seed = 7, points = 6000, agents: count = 8, rows = 5, piece = 14, samples = 0 } = {}) {
  const random = seeded(seed);
  const cloud = bridgePoints(points, random);
  const arcs = bridgeArcs(rows), tasks = pieces(arcs, piece), agents = fleet(count);
  const plan = { start: 0.6, partition: [0.66, 0.76], death: { t: 0.9, agent: Math.min(5, count) }, loss: 0.12 };
  const { record, bidders, living, end_s, agreed_s } = auction(agents, tasks, plan, random);
  const table = living[0].table;
  const routes = living.map((one) => route(one.agent, tasks.filter((_, i) => table[i].winner === one.id)));
  const makespan = Math.max(...routes.map(({ time_s }) => time_s));
  return {
    schema: 1, name: 'made bridge', run: 'runs/made', live: false, build: { version: '0.1.0', commit: 'fixture' },
    summary: [['policy', 'claims'], ['score', 'minimax'], ['agreement', `proven ${agreed_s.toFixed(2)} s after launch`], ['makespan', `${makespan.toFixed(1)} s`], ['checked', 'conflict_free yes, complete yes']],
    structure: { points: base64(cloud) },
    arcs, tasks, agents,
    auction: {
      start_s: plan.start, end_s,
      views: bidders.map((one) => ({ agent: one.id, lives: 1, changes: one.changes })),
      decisions: record.decisions.sort((a, b) => a.t_s - b.t_s),
      states: record.states.sort((a, b) => a.t_s - b.t_s),
      events: record.events.sort((a, b) => a.t_s - b.t_s),
      links: { bin_s: record.bin_s, rows: [...record.links.values()] },
    },
    mission: { routes },
    explanations: record.explanations,
    ...(samples > 0 ? { coverage: coverage(samples, routes) } : {}),
  };
}

export const packed = (data) => gzipSync(JSON.stringify(data), { level: 9 });

/** The built page with `data` in it, as `arcbid report` does it. */
export function embed(page, data) {
  const element = `<script id="arcbid-data" type="application/gzip-base64">${packed(data).toString('base64')}</script>`;
  return page.replace('<!--arcbid-data-->', () => element);
}
