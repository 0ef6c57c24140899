// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over the auction's time, sampled where something happened.
import type { ViewModel } from './view_model';

/** At most `most` of the moments, evenly chosen, between the ends of the auction. */
export function sampleTimes(model: ViewModel, most: number): number[] {
  const { moments } = model;
  const stride = Math.max(1, Math.ceil(moments.length / most));
  const times = [model.first_s];
  for (let i = stride - 1; i < moments.length; i += stride) if (moments[i] > times[times.length - 1]) times.push(moments[i]);
  if (model.last_s > times[times.length - 1]) times.push(model.last_s);
  return times;
}

/** Metres that each agent (in the order of `agents`) holds in the fleet's allocation. */
export function loadSeries(model: ViewModel, times: number[]): number[][] {
  const series = model.agents.map(() => [] as number[]);
  for (const t of times)
    model.loads(model.owners('fleet', t)).forEach((load, i) => series[i].push(load.metres));
  return series;
}

export function disputeSeries(model: ViewModel, times: number[]): number[] {
  return times.map((t) => model.disputed(t).reduce((sum, one) => sum + one, 0));
}

/** Below this the series stay nine tenths of the time: first bids, for everything, would flatten the rest. */
export function usualMost(times: number[], series: number[][]): number {
  const spans = times.map((t, i) => ({ most: Math.max(0, ...series.map((values) => values[i])), lasts: (times[i + 1] ?? t) - t }))
    .filter(({ most }) => most > 0).sort((a, b) => b.most - a.most);
  let above = spans.reduce((sum, { lasts }) => sum + lasts, 0) / 10;
  const usual = spans.find(({ lasts }) => (above -= lasts) < 0) ?? spans[0];
  return usual ? 1.15 * usual.most : 1;
}
