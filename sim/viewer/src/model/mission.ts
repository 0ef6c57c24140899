// SPDX-License-Identifier: GPL-3.0-or-later
// Where the drones are, seconds after take-off.
import type { Agent, Route } from './data';
import { countUpTo } from './search';

export interface Place { position: [number, number, number]; arc: number; flying: boolean }

export class Mission {
  readonly duration_s: number;
  private readonly routes = new Map<number, Route>();
  private readonly homes = new Map<number, number[]>();

  constructor(agents: Agent[], routes: Route[]) {
    for (const agent of agents) this.homes.set(agent.agent, agent.home);
    for (const route of routes) if (route.at_s.length > 0) this.routes.set(route.agent, route);
    this.duration_s = Math.max(0, ...[...this.routes.values()].map((route) => route.at_s[route.at_s.length - 1]));
  }

  routeOf(agent: number): Route | undefined { return this.routes.get(agent); }
  get known(): boolean { return this.routes.size > 0; }

  placeOf(agent: number, t: number): Place {
    const route = this.routes.get(agent);
    const home = this.homes.get(agent) ?? [0, 0, 0];
    if (!route) return { position: [home[0], home[1], home[2]], arc: -1, flying: false };
    const { at_s, line } = route;
    const last = at_s.length - 1;
    const k = Math.min(Math.max(countUpTo(at_s.length, (i) => at_s[i], t) - 1, 0), Math.max(last - 1, 0));
    const span = last > 0 ? at_s[k + 1] - at_s[k] : 0;
    const part = span > 0 ? Math.min(Math.max((t - at_s[k]) / span, 0), 1) : 0;
    const along = (axis: number): number => {
      const from = line[3 * k + axis], to = line[3 * Math.min(k + 1, last) + axis];
      return from + (to - from) * part;
    };
    const flying = t > at_s[0] && t < at_s[last];
    return { position: [along(0), along(1), along(2)], arc: flying ? (route.arc[k] ?? -1) : -1, flying };
  }

  /** When each drone is back, in time order. */
  landings(): { agent: number; t_s: number }[] {
    return [...this.routes.values()]
      .map((route) => ({ agent: route.agent, t_s: route.at_s[route.at_s.length - 1] }))
      .sort((a, b) => a.t_s - b.t_s || a.agent - b.agent);
  }
}
