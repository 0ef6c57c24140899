// SPDX-License-Identifier: GPL-3.0-or-later
// How much each agent has: a row each, and the same over the auction's time.
import uPlot from 'uplot';
import type { App, Part } from '../app';
import { h, panel, setText, swatch, themeColour } from '../dom';
import { DASHES, lookOf } from '../model/palette';
import { loadSeries, sampleTimes, usualMost } from '../model/series';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';

const SAMPLES = 400;

interface Row { agent: number; button: HTMLButtonElement; bar: HTMLElement; value: HTMLElement; state: HTMLElement; mark: HTMLElement }

export class LoadPanel implements Part {
  private readonly rows = h('ul', { class: 'loads', 'aria-label': 'Agents' });
  private readonly chartPlace = h('div', { class: 'chart', role: 'img', 'aria-label': 'Metres each agent holds over the time of the auction' });
  private items: Row[] = [];
  private plot: uPlot | undefined;
  private series: number[][] = [];
  private times: number[] = [];
  private drawn = '';
  private now: Snapshot | undefined;

  constructor(private readonly app: App, place: HTMLElement) {
    place.append(panel('Load', this.rows, this.chartPlace));
    new ResizeObserver(() => this.plot?.setSize({ width: this.chartPlace.clientWidth, height: 110 })).observe(this.chartPlace);
  }

  show(model: ViewModel): void {
    this.times = sampleTimes(model, SAMPLES);
    this.series = loadSeries(model, this.times);
    this.drawn = '';
    if (this.items.map((row) => row.agent).join() === model.agents.join()) return;
    this.items = model.agents.map((agent) => this.makeRow(agent));
    this.rows.replaceChildren(...this.items.map((row) => h('li', {}, row.button)));
  }

  private makeRow(agent: number): Row {
    const mark = h('span', { class: 'mark' }), state = h('span', { class: 'state' });
    const bar = h('span', { class: 'fill' }), value = h('span', { class: 'value' });
    const choose = (): void => this.app.chooseAgent(this.app.agent === agent ? null : agent);
    const button = h('button', { class: 'load', onclick: choose }, mark, h('b', {}, String(agent)), h('span', { class: 'bar' }, bar), value, state);
    return { agent, button, bar, value, state, mark };
  }

  update(now: Snapshot): void {
    this.now = now;
    const { model } = now;
    const loads = model.loads(now.owners);
    const most = Math.max(...loads.map((load) => load.metres), 1e-9);
    this.items.forEach((row, i) => {
      const { metres, tasks } = loads[i];
      const look = lookOf(i, now.dark);
      const alive = now.alive(row.agent);
      row.bar.style.width = `${100 * (now.track === 'mission' ? this.partFlown(now, row.agent) : metres / most)}%`;
      row.bar.style.backgroundColor = look.css;
      row.bar.dataset.pattern = String(look.pattern);
      setText(row.value, now.track === 'mission' ? this.flown(now, row.agent) : `${tasks} · ${metres.toFixed(0)} m`);
      const state = model.fleet.stateOf(row.agent, now.t);
      setText(row.state, !alive ? '✕ dead' : now.track === 'auction' ? state : '');
      row.button.classList.toggle('dead', !alive);
      row.button.setAttribute('aria-pressed', String(now.agent === row.agent));
      row.button.title = `agent ${row.agent}: ${tasks} pieces, ${metres.toFixed(1)} m, ${alive ? state : 'dead'}`;
    });
    this.redraw(now);
    this.plot?.redraw(false);
  }

  /** Of the mission's whole time, how much this agent has flown. */
  private partFlown({ model, flight_s }: Snapshot, agent: number): number {
    const end = model.mission.routeOf(agent)?.at_s.at(-1) ?? 0;
    return Math.min(flight_s, end) / Math.max(model.mission.duration_s, 1e-9);
  }

  private flown(now: Snapshot, agent: number): string {
    const route = now.model.mission.routeOf(agent);
    if (!route) return 'no route';
    const end = route.at_s[route.at_s.length - 1];
    return now.flight_s >= end ? `back at ${end.toFixed(0)} s` : `${now.flight_s.toFixed(0)} of ${end.toFixed(0)} s`;
  }

  private redraw(now: Snapshot): void {
    const key = `${now.dark} ${now.agent}`;
    if (this.drawn === key && this.plot) return;
    this.drawn = key;
    const marks = this.items.map((_, i) => swatch(i, now.dark));
    this.items.forEach((row, i) => row.mark.replaceChildren(marks[i]));
    this.plot?.destroy();
    this.plot = new uPlot(this.options(now), [this.times, ...this.series], this.chartPlace);
  }

  private options(now: Snapshot): uPlot.Options {
    const axis = { stroke: themeColour('--dim'), font: '10px system-ui', grid: { stroke: themeColour('--line'), width: 1 }, ticks: { show: false } };
    const stepped = uPlot.paths.stepped!({ align: 1 });
    return {
      width: Math.max(this.chartPlace.clientWidth, 100), height: 110, padding: [8, 6, 0, 0],
      legend: { show: false }, cursor: { show: false },
      scales: { x: { time: false }, y: { range: [0, usualMost(this.times, this.series)] } },
      axes: [{ ...axis, size: 18, gap: 2, values: (_, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: 38, gap: 3, values: (_, ticks) => ticks.map((tick) => `${tick} m`) }],
      series: [{}, ...this.items.map((row, i) => {
        const look = lookOf(i, now.dark);
        const faint = now.agent !== null && now.agent !== row.agent;
        return { stroke: look.css, dash: DASHES[look.pattern], width: now.agent === row.agent ? 2.5 : 1.25, alpha: faint ? 0.2 : 1, paths: stepped, points: { show: false } };
      })],
      hooks: { draw: [(plot) => this.drawNow(plot)] },
    };
  }

  /** The moment that is shown. */
  private drawNow(plot: uPlot): void {
    if (!this.now) return;
    const x = Math.round(plot.valToPos(this.now.t, 'x', true));
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.fillStyle = themeColour('--accent');
    ctx.fillRect(x - 1, bbox.top, 2, bbox.height);
    ctx.restore();
  }
}
