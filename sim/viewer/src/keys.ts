// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard, and the sheet that tells of it.
import type { App } from './app';
import { h } from './dom';
import { moveToEvent, step } from './steps';
import type { Track } from './model/clock';

const TURN = 0.12;

const SHEET: [string, string][] = [
  ['Space', 'play, pause'], ['← →', 'one step back, on (with Shift: ten)'], ['[ ]', 'previous, next event'],
  ['Home End', 'begin, end of the track'], ['1 2', 'auction time, mission time'], [', .', 'slower, faster'], ['R', 'loop'],
  ['V Shift V', 'next, previous view: the fleet, then as each agent sees it'], ['N P', 'next, previous piece'],
  ['C Shift C', 'next, previous colours of the structure: plain, coverage, redundancy'],
  ['M Shift M', 'to where the next, previous agent comes nearest to the structure'],
  ['L', 'owners beside the arcs'], ['W A S D', 'turn the view'], ['+ −', 'nearer, farther'], ['F', 'fit into view'],
  ['T', 'light, dark, as the system has it'], ['Esc', 'choose nothing'], ['?', 'this sheet'],
  ['Tab Enter', 'go through lists and buttons, use one'],
];

export class Keys {
  private readonly sheet = h('dialog', { id: 'help', 'aria-label': 'Keys' }, h('h2', {}, 'Keys'),
    h('dl', {}, ...SHEET.flatMap(([key, what]) => [h('dt', {}, key), h('dd', {}, what)])),
    h('form', { method: 'dialog' }, h('button', {}, 'Close')));

  constructor(private readonly app: App, place: HTMLElement, private readonly switchTheme: () => void) {
    place.append(this.sheet);
    document.addEventListener('keydown', (event) => this.key(event));
  }

  help(): void { if (this.sheet.open) this.sheet.close(); else this.sheet.showModal(); }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || !this.app.model) return;
    const target = event.target as Element;
    if (event.key === '?') { event.preventDefault(); this.help(); return; }
    // Lists and buttons keep the keys that work them.
    if (this.sheet.open || target.matches('select, input, textarea')) return;
    if (event.key === ' ' && target.matches('button:not(#play), summary')) return;
    const act = this.actions(event)[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  private actions(event: KeyboardEvent): Record<string, () => void> {
    const { app } = this;
    const { clock, scene } = app;
    const many = event.shiftKey ? 10 : 1;
    const turn = (aside: number, up: number, closer?: number) => (): void => scene.camera.turn(aside, up, closer);
    const track = (name: Track) => (): void => app.seek(clock.now[name], name);
    return {
      ' ': () => app.play(!clock.playing),
      ArrowLeft: () => step(app, -many), ArrowRight: () => step(app, many),
      '[': () => moveToEvent(app, -1), ']': () => moveToEvent(app, 1),
      Home: () => app.seek(clock.span.from), End: () => app.seek(clock.span.to),
      1: track('auction'), 2: track('mission'),
      ',': () => app.changeRate(-1), '.': () => app.changeRate(1),
      r: () => { clock.loop = !clock.loop; app.changed(); },
      v: () => app.nextPerspective(event.shiftKey ? -1 : 1),
      n: () => app.nextTask(1), p: () => app.nextTask(-1),
      l: () => { app.labels = !app.labels; app.changed(); },
      w: turn(0, -TURN), s: turn(0, TURN), a: turn(-TURN, 0), d: turn(TURN, 0),
      '+': turn(0, 0, 1 / 1.15), '=': turn(0, 0, 1 / 1.15), '-': turn(0, 0, 1.15),
      c: () => app.nextColouring(event.shiftKey ? -1 : 1),
      m: () => app.nextMark(event.shiftKey ? -1 : 1),
      f: () => { scene.camera.fit(); app.changed(); },
      t: this.switchTheme,
      Escape: () => app.chooseNothing(),
    };
  }
}
