// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown, and the loop that shows it: a frame is drawn when something has changed.
import { COLOURINGS, type Colouring } from './model/colouring';
import { marksOf } from './model/coverage';
import { Clock, RATES, type Track } from './model/clock';
import type { RunData } from './model/data';
import { ViewModel, type Perspective } from './model/view_model';
import { SceneView } from './scene/scene';
import type { Snapshot } from './snapshot';

/** A part of the page. */
export interface Part {
  /** A run is here, or more of it. */
  show?(model: ViewModel): void;
  update(now: Snapshot): void;
}

/** Who owns what, and when and to whose mind that was asked. */
type Allocated = Pick<Snapshot, 'model' | 'perspective' | 't' | 'owners' | 'disputed' | 'disputes'>;

/** While time runs, text and charts change only this often. */
const PANELS_EVERY_MS = 100;
/** How far off a place is looked at, in clearances: it and the structure by it fill the picture. */
const MARK_FROM = 12;

export class App {
  readonly clock = new Clock();
  readonly scene: SceneView;
  model: ViewModel | undefined;
  perspective: Perspective = 'fleet';
  /** By id, for a piece keeps it while a run goes on. */
  task: number | null = null;
  hoverSlot = -1;
  agent: number | null = null;
  colouring: Colouring = 'plain';
  only: number | null = null;
  /** The agent whose nearest place to the structure is chosen. */
  mark: number | null = null;
  labels = true;
  dark = false;
  frames = 0;
  private readonly parts: Part[] = [];
  private scheduled = false;
  private panelsDue = true;
  private lastFrame = 0;
  private lastPanels = 0;
  private known: Allocated | undefined;

  constructor(canvas: HTMLCanvasElement, overlay: HTMLCanvasElement) {
    this.scene = new SceneView(canvas, overlay, () => this.redraw());
    new ResizeObserver(() => { this.scene.resize(); this.changed(); }).observe(canvas);
  }

  add(part: Part): void { this.parts.push(part); }

  load(data: RunData): void {
    const model = new ViewModel(data);
    const before = this.model;
    const { clock } = this;
    const follows = before !== undefined && clock.track === 'auction' && clock.atEnd;
    this.model = model;
    if (!data.coverage?.samples) this.colouring = 'plain';
    clock.setSpan('auction', { from: model.first_s, to: model.last_s });
    clock.setSpan('mission', { from: 0, to: model.mission.duration_s });
    if (!before) {
      clock.suggestRate('auction');
      clock.seek(data.live ? model.last_s : model.first_s);
    } else if (follows) {
      clock.seek(model.last_s);
    }
    // Take-off is known late in a live run: its rate is chosen when it is.
    if (!before?.mission.known) clock.suggestRate('mission');
    this.scene.show(model, this.dark, before !== undefined && sameGround(before.data, data));
    for (const part of this.parts) part.show?.(model);
    this.changed();
  }

  /** Something else is to be shown; the next frame shows it. */
  changed(): void {
    this.panelsDue = true;
    this.redraw();
  }

  /** Only the picture changes. */
  redraw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((ms) => this.frame(ms));
  }

  private frame(ms: number): void {
    this.scheduled = false;
    if (!this.model) return;
    if (this.clock.playing && this.lastFrame > 0) {
      this.clock.advance(Math.max(ms - this.lastFrame, 0) / 1000);
      if (!this.clock.playing) this.panelsDue = true;
    }
    this.lastFrame = this.clock.playing ? ms : 0;
    const now = this.snapshot();
    this.scene.render(now);
    if (this.panelsDue || (this.clock.playing && ms - this.lastPanels >= PANELS_EVERY_MS)) {
      this.lastPanels = ms;
      this.panelsDue = false;
      for (const part of this.parts) part.update(now);
    }
    this.frames++;
    document.documentElement.dataset.frames = String(this.frames);
    if (this.clock.playing) this.redraw();
  }

  snapshot(): Snapshot {
    const model = this.model!;
    const { clock } = this;
    const flies = clock.track === 'mission';
    const t = flies ? model.last_s : clock.now.auction;
    const { owners, disputed, disputes } = this.allocationAt(model, t);
    const slot = this.task === null ? -1 : (model.slotOf(this.task) ?? -1);
    return {
      model, track: clock.track, t, flight_s: flies ? clock.now.mission : 0, dark: this.dark, labels: this.labels,
      perspective: this.perspective, owners, disputed, disputes, slot, hover: this.hoverSlot, agent: this.agent,
      colouring: this.colouring, only: this.only, mark: this.mark,
      alive: (agent) => model.fleet.isAlive(agent, t),
    };
  }

  private allocationAt(model: ViewModel, t: number): Allocated {
    const { known, perspective } = this;
    if (known && known.model === model && known.perspective === perspective && known.t === t) return known;
    const owners = model.owners(perspective, t);
    const disputed = model.disputed(t);
    const disputes = disputed.reduce((sum, one) => sum + one, 0);
    return (this.known = { model, perspective, t, owners, disputed, disputes });
  }

  seek(t: number, track: Track = this.clock.track): void {
    this.clock.track = track;
    this.clock.seek(t);
    this.changed();
  }

  play(playing: boolean): void {
    this.clock.play(playing);
    this.lastFrame = 0;
    this.changed();
  }

  chooseTask(task: number | null): void { this.task = task; this.changed(); }
  chooseAgent(agent: number | null): void { this.agent = agent; this.changed(); }

  nextTask(direction: 1 | -1): void {
    const tasks = this.model?.tasks ?? [];
    if (tasks.length === 0) return;
    const slot = this.task === null ? -1 : (this.model?.slotOf(this.task) ?? -1);
    const next = slot < 0 ? (direction > 0 ? 0 : tasks.length - 1) : (slot + direction + tasks.length) % tasks.length;
    this.chooseTask(tasks[next].task);
  }

  colour(colouring: Colouring): void {
    this.colouring = this.model?.data.coverage?.samples ? colouring : 'plain';
    this.only = null;
    this.changed();
  }

  nextColouring(direction: 1 | -1): void {
    const { length } = COLOURINGS;
    this.colour(COLOURINGS[(COLOURINGS.indexOf(this.colouring) + direction + length) % length]);
  }

  /** Lets one entry of the legend stand out, or all alike again. */
  chooseOnly(entry: number): void { this.only = this.only === entry ? null : entry; this.changed(); }

  /** To where this agent comes nearest to the structure. */
  goToMark(agent: number): void {
    const coverage = this.model?.data.coverage;
    const mark = marksOf(coverage).find((one) => one.agent === agent);
    if (!mark) return;
    this.mark = agent;
    this.scene.camera.goTo(mark.nearest.at_m, MARK_FROM * Math.max(coverage?.figures?.safety_m ?? 0, mark.nearest.distance_m));
    this.changed();
  }

  nextMark(direction: 1 | -1): void {
    const marks = marksOf(this.model?.data.coverage);
    if (marks.length === 0) return;
    const at = marks.findIndex(({ agent }) => agent === this.mark);
    const next = at < 0 ? (direction > 0 ? 0 : marks.length - 1) : (at + direction + marks.length) % marks.length;
    this.goToMark(marks[next].agent);
  }

  chooseNothing(): void {
    this.only = this.mark = null;
    this.chooseTask(null);
    this.chooseAgent(null);
  }

  nextPerspective(direction: 1 | -1): void {
    const all: Perspective[] = ['fleet', ...(this.model?.agents ?? [])];
    this.perspective = all[(all.indexOf(this.perspective) + direction + all.length) % all.length];
    this.changed();
  }

  changeRate(direction: 1 | -1): void {
    const rates = RATES[this.clock.track];
    const at = rates.indexOf(this.clock.rate[this.clock.track]);
    this.clock.rate[this.clock.track] = rates[Math.min(Math.max(at + direction, 0), rates.length - 1)];
    this.changed();
  }

  hover(slot: number): void { if (slot !== this.hoverSlot) { this.hoverSlot = slot; this.redraw(); } }
}

/** A live run goes on over the same structure: then the camera stays. */
const sameGround = (a: RunData, b: RunData): boolean =>
  a.structure.points?.length === b.structure.points?.length && a.agents.length === b.agents.length && a.arcs.length === b.arcs.length;
