// SPDX-License-Identifier: GPL-3.0-or-later
// Who hears whom: a cell for each pair, the darker the more was lost on the way lately.
import type { App, Part } from '../app';
import { fitCanvas, h, panel, setText, themeColour } from '../dom';
import type { LinkCounts } from '../model/links';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';

const MARGIN = 18;
/** A larger one needs the panel's whole width. */
const SMALL_FLEET = 12;
const WINDOWS: [string, number][] = [['last 0.1 s', 0.1], ['last 0.5 s', 0.5], ['last 2 s', 2], ['since launch', Infinity]];

type Inks = Record<'dim' | 'cell' | 'loss' | 'paper' | 'accent', string>;

/** Asked once a drawing: there are thousands of cells. */
const inksNow = (): Inks => ({
  dim: themeColour('--dim'), cell: themeColour('--cell'), loss: themeColour('--loss'), paper: themeColour('--paper'), accent: themeColour('--accent'),
});

export class LinkPanel implements Part {
  private readonly canvas = h('canvas', { class: 'matrix', tabindex: 0, role: 'img', 'aria-label': 'Link matrix' });
  private readonly said = h('p', { class: 'facts', id: 'link-facts', 'aria-live': 'polite' });
  private readonly span = h('select', { 'aria-label': 'Losses of which time' },
    ...WINDOWS.map(([name, seconds]) => h('option', { value: seconds }, name)));
  private readonly place: HTMLElement;
  private drawn = '';
  private cell: [number, number] | undefined;
  private counts: LinkCounts | undefined;
  private now: Snapshot | undefined;

  constructor(app: App, place: HTMLElement) {
    this.span.addEventListener('change', () => app.changed());
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerleave', () => this.choose(undefined));
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    this.place = h('div', { class: 'links' }, this.canvas, h('div', {}, this.span, this.said, h('p', { class: 'dim' }, 'a row: from, a column: to; the deeper a cell, the more was lost; ✕ all of it')));
    place.append(panel('Links', this.place));
  }

  show(model: ViewModel): void {
    this.drawn = '';
    this.place.classList.toggle('large', model.agents.length > SMALL_FLEET);
  }

  update(now: Snapshot): void {
    this.now = now;
    const { links } = now.model;
    const key = `${links.binAt(now.t)} ${this.span.value} ${now.dark} ${this.canvas.clientWidth}`;
    if (key === this.drawn) return;
    this.drawn = key;
    this.counts = links.at(now.t, Number(this.span.value));
    this.draw();
  }

  private draw(): void {
    const context = fitCanvas(this.canvas);
    if (!context || !this.now || !this.counts) return;
    const { agents } = this.now.model;
    const step = this.step();
    const inks = inksNow();
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    context.font = `${Math.min(10, step)}px system-ui, sans-serif`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillStyle = inks.dim;
    const every = Math.ceil(14 / step);
    agents.forEach((agent, i) => {
      if (i % every !== 0) return;
      context.fillText(String(agent), MARGIN + (i + 0.5) * step, MARGIN / 2);
      context.fillText(String(agent), MARGIN / 2, MARGIN + (i + 0.5) * step);
    });
    for (let from = 0; from < agents.length; from++) for (let to = 0; to < agents.length; to++) this.drawCell(context, inks, from, to, step);
    this.say();
  }

  private step(): number {
    return (Math.min(this.canvas.clientWidth, this.canvas.clientHeight) - MARGIN) / Math.max(this.now?.model.agents.length ?? 1, 1);
  }

  private drawCell(context: CanvasRenderingContext2D, inks: Inks, from: number, to: number, step: number): void {
    const size = this.now!.model.agents.length;
    const sent = this.counts!.sent[from * size + to], lost = this.counts!.lost[from * size + to];
    const x = MARGIN + to * step, y = MARGIN + from * step, gap = step > 6 ? 1 : 0;
    context.fillStyle = inks.cell;
    if (from !== to) context.fillRect(x, y, step - gap, step - gap);
    if (sent > 0 && from !== to) {
      const share = lost / sent;
      // Lightness alone tells the share; what is cut altogether is crossed out as well.
      context.fillStyle = inks.loss;
      context.globalAlpha = lost > 0 ? 0.15 + 0.85 * share : 0;
      context.fillRect(x, y, step - gap, step - gap);
      context.globalAlpha = 1;
      context.fillStyle = inks.dim;
      if (lost === 0) context.fillRect(x + step / 2 - 1, y + step / 2 - 1, 2, 2);
      if (share === 1) this.cross(context, inks.paper, x, y, step - gap);
    }
    if (this.cell?.[0] === from && this.cell[1] === to) {
      context.strokeStyle = inks.accent;
      context.lineWidth = 2;
      context.strokeRect(x, y, step - gap, step - gap);
    }
  }

  private cross(context: CanvasRenderingContext2D, ink: string, x: number, y: number, size: number): void {
    context.strokeStyle = ink;
    context.lineWidth = Math.max(size / 10, 0.75);
    const inset = size * 0.28;
    context.beginPath();
    context.moveTo(x + inset, y + inset);
    context.lineTo(x + size - inset, y + size - inset);
    context.moveTo(x + size - inset, y + inset);
    context.lineTo(x + inset, y + size - inset);
    context.stroke();
  }

  private say(): void {
    const { agents, links } = this.now!.model;
    const { sent, lost, delayed, duplicated } = this.counts!;
    let text = 'No message was counted.';
    if (this.cell) {
      const at = this.cell[0] * agents.length + this.cell[1];
      text = `${agents[this.cell[0]]} → ${agents[this.cell[1]]}: ${sent[at]} sent, ${lost[at]} lost, ${delayed[at]} delayed, ${duplicated[at]} duplicated`;
    } else if (links.known) {
      const sum = (counts: Float64Array): number => counts.reduce((total, one) => total + one, 0);
      const cut = sent.reduce((count, one, i) => count + (one > 0 && lost[i] === one ? 1 : 0), 0);
      text = `${sum(lost)} of ${sum(sent)} messages lost, ${cut} links silent`;
    }
    setText(this.said, text);
    this.canvas.setAttribute('aria-label', `Link matrix. ${text}. Arrow keys choose a link.`);
  }

  private choose(cell: [number, number] | undefined): void { this.cell = cell; this.draw(); }

  private point(event: PointerEvent): void {
    const size = this.now?.model.agents.length ?? 0, step = this.step();
    const to = Math.floor((event.offsetX - MARGIN) / step), from = Math.floor((event.offsetY - MARGIN) / step);
    this.choose(from >= 0 && to >= 0 && from < size && to < size && from !== to ? [from, to] : undefined);
  }

  private key(event: KeyboardEvent): void {
    const moves: Record<string, [number, number]> = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };
    const move = moves[event.key], size = this.now?.model.agents.length ?? 0;
    if (!move || size === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const within = (value: number): number => Math.min(Math.max(value, 0), size - 1);
    const [from, to] = this.cell ?? [0, 0];
    this.choose([within(from + move[0]), within(to + move[1])]);
  }
}
