// SPDX-License-Identifier: GPL-3.0-or-later
// One time line: drag or step along it, marks to jump to, a curve of what went on.
import { eventMark } from './event_marks';
import { fitCanvas, h, setText, themeColour } from './dom';
import { timeText } from './text';
import type { Span, Track } from './model/clock';

export interface Mark { t_s: number; kind: string; title: string }
export interface Curve { times: number[]; values: number[]; name: string }

export class TrackBar {
  readonly element: HTMLElement;
  private readonly slider = h('div', { class: 'slider', role: 'slider', tabindex: 0 });
  private readonly curveCanvas = h('canvas', { 'aria-hidden': 'true' });
  private readonly done = h('div', { class: 'done' });
  private readonly head = h('div', { class: 'head' });
  private readonly marks = h('div', { class: 'marks' });
  private readonly time = h('output', { class: 'time' });
  private readonly about = h('span', { class: 'dim' });
  private span: Span = { from: 0, to: 0 };
  private curve: Curve | undefined;

  constructor(private readonly track: Track, name: string, private readonly seek: (t: number) => void, choose: () => void) {
    this.slider.setAttribute('aria-label', `${name} time`);
    this.slider.append(this.curveCanvas, this.done, this.marks, this.head);
    const button = h('button', { class: 'track-name', id: `track-${track}`, onclick: choose }, h('b', {}, name), this.time, this.about);
    this.element = h('div', { class: 'track' }, button, this.slider);
    this.slider.addEventListener('pointerdown', (event) => this.drag(event));
    this.slider.addEventListener('pointermove', (event) => { if (this.slider.hasPointerCapture(event.pointerId)) this.seekTo(event); });
    new ResizeObserver(() => this.drawCurve()).observe(this.slider);
  }

  private drag(event: PointerEvent): void {
    if (event.button !== 0 || (event.target as Element).closest('.mark-button')) return;
    this.slider.setPointerCapture(event.pointerId);
    this.seekTo(event);
  }

  private seekTo(event: PointerEvent): void {
    const { left, width } = this.slider.getBoundingClientRect();
    const part = Math.min(Math.max((event.clientX - left) / Math.max(width, 1), 0), 1);
    this.seek(this.span.from + part * (this.span.to - this.span.from));
  }

  private partOf(t: number): number {
    const length = this.span.to - this.span.from;
    return length > 0 ? Math.min(Math.max((t - this.span.from) / length, 0), 1) : 0;
  }

  show(span: Span, marks: Mark[], curve?: Curve): void {
    this.span = span;
    this.curve = curve;
    this.marks.replaceChildren(...marks.map(({ t_s, kind, title }) => {
      // The list of events is the way there by key; the marks are for the pointer.
      const button = h('button', { class: 'mark-button', tabindex: -1, title, 'aria-label': title, onclick: () => this.seek(t_s) }, eventMark(kind));
      button.style.left = `${100 * this.partOf(t_s)}%`;
      return button;
    }));
    this.slider.setAttribute('aria-valuemin', String(span.from));
    this.slider.setAttribute('aria-valuemax', String(span.to));
    this.slider.title = curve ? `grey: ${curve.name}` : '';
    this.drawCurve();
  }

  drawCurve(): void {
    const context = fitCanvas(this.curveCanvas);
    if (!context) return;
    const { clientWidth: width, clientHeight: height } = this.curveCanvas;
    context.clearRect(0, 0, width, height);
    if (!this.curve || this.curve.values.length === 0) return;
    const { times, values } = this.curve;
    const most = Math.max(...values, 1);
    context.fillStyle = themeColour('--curve');
    context.beginPath();
    context.moveTo(0, height);
    let level = height;
    times.forEach((t, i) => {
      const x = width * this.partOf(t);
      context.lineTo(x, level);
      level = height - (height - 3) * (values[i] / most);
      context.lineTo(x, level);
    });
    context.lineTo(width, level);
    context.lineTo(width, height);
    context.fill();
  }

  update(t: number, active: boolean, about: string): void {
    const percent = `${100 * this.partOf(t)}%`;
    this.done.style.width = percent;
    this.head.style.left = percent;
    setText(this.time, timeText(this.track, t));
    setText(this.about, about);
    this.element.classList.toggle('active', active);
    this.slider.setAttribute('aria-valuenow', String(t));
    this.slider.setAttribute('aria-valuetext', `${timeText(this.track, t)}, ${about}`);
  }
}
