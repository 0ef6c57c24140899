// SPDX-License-Identifier: GPL-3.0-or-later
// What `arcbid view` serves of a run that is going on, on loopback.
import { createServer } from 'node:http';
import { packed } from './fixture.mjs';

const upTo = (items, t) => items.filter(({ t_s }) => t_s <= t);

/** The run as it was known at `t`. */
export function knownAt(data, t) {
  const { auction } = data;
  return {
    ...data, live: true, mission: { routes: [] },
    auction: {
      ...auction, end_s: t, decisions: upTo(auction.decisions, t), states: upTo(auction.states, t), events: upTo(auction.events, t),
      views: auction.views.map((view) => ({ ...view, changes: upTo(view.changes, t) })),
    },
  };
}

export async function serve(page, first) {
  const listeners = new Set();
  const paths = [];
  let body = packed(first), version = 1;
  const server = createServer((request, response) => {
    paths.push(request.url);
    if (request.url === '/') response.writeHead(200, { 'content-type': 'text/html' }).end(page);
    else if (request.url === '/data') response.writeHead(200, { 'content-type': 'application/json', 'content-encoding': 'gzip' }).end(body);
    else if (request.url === '/updates') {
      response.writeHead(200, { 'content-type': 'text/event-stream', 'cache-control': 'no-store' });
      response.write(`data: ${JSON.stringify({ version, ended: false })}\n\n`);
      listeners.add(response);
      response.on('close', () => listeners.delete(response));
    } else response.writeHead(404).end();
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return {
    url: `http://127.0.0.1:${server.address().port}/`, paths,
    update(data, ended) {
      body = packed(data);
      version++;
      for (const one of listeners) one.write(`data: ${JSON.stringify({ version, ended })}\n\n`);
    },
    /** As often as one likes. */
    close: () => new Promise((done) => { server.close(() => done()); server.closeAllConnections(); }),
  };
}
