// SPDX-License-Identifier: GPL-3.0-or-later
// Routes as strokes: stretches along one arc, and the transits between them.
import type { Rgb } from '../model/palette';
import type { ViewModel } from '../model/view_model';
import type { Stroke } from './fat_lines';

export interface RouteStroke extends Stroke { agent: number; transit: boolean }

const known = new WeakMap<ViewModel, RouteStroke[]>();

export function routeStrokes(model: ViewModel): RouteStroke[] {
  let strokes = known.get(model);
  if (!strokes) known.set(model, (strokes = model.agents.flatMap((agent) => strokesOf(model, agent))));
  return strokes;
}

function strokesOf(model: ViewModel, agent: number): RouteStroke[] {
  const route = model.mission.routeOf(agent);
  if (!route) return [];
  const strokes: RouteStroke[] = [];
  const legs = Math.max(route.at_s.length - 1, 0);
  for (let first = 0, k = 0; k < legs; k++) {
    if (k + 1 < legs && route.arc[k + 1] === route.arc[first]) continue;
    strokes.push({
      agent, transit: (route.arc[first] ?? -1) < 0,
      line: route.line.slice(3 * first, 3 * k + 6), at_s: route.at_s.slice(first, k + 2),
    });
    first = k + 1;
  }
  return strokes;
}

export function mixed(rgb: Rgb, background: string, part: number): Rgb {
  return rgb.map((value, i) => value + (parseInt(background.slice(1 + 2 * i, 3 + 2 * i), 16) - value) * part) as Rgb;
}
