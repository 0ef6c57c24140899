// SPDX-License-Identifier: GPL-3.0-or-later
// Two times on one page: the auction's, in seconds since launch, and the mission's, since take-off.

export type Track = 'auction' | 'mission';
export interface Span { from: number; to: number }

export const RATES: Record<Track, number[]> = {
  auction: [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10],
  mission: [0.5, 1, 2, 5, 10, 20, 50, 100, 200],
};

/** No frame may leap over more than this of the wall clock: what happens is to be seen. */
const LONGEST_STEP_S = 0.1;
/** Over how long the real rate is taken. */
const MEASURED_S = 1;
/** What a whole track should last at the rate that is offered first. */
const COMFORTABLE_S = 20;

export class Clock {
  track: Track = 'auction';
  playing = false;
  loop = false;
  readonly rate: Record<Track, number> = { auction: 1, mission: 1 };
  readonly now: Record<Track, number> = { auction: 0, mission: 0 };
  readonly spans: Record<Track, Span> = { auction: { from: 0, to: 0 }, mission: { from: 0, to: 0 } };
  private steps: { wall: number; shown: number }[] = [];

  setSpan(track: Track, span: Span): void {
    this.spans[track] = span;
    this.seek(this.now[track], track);
  }

  /** The listed rate at which the whole track lasts about as long as one cares to watch. */
  suggestRate(track: Track): void {
    const { from, to } = this.spans[track];
    const wanted = (to - from) / COMFORTABLE_S;
    const far = (rate: number): number => Math.abs(Math.log(rate / Math.max(wanted, 1e-9)));
    this.rate[track] = RATES[track].reduce((best, rate) => (far(rate) < far(best) ? rate : best));
  }

  get t(): number { return this.now[this.track]; }
  get span(): Span { return this.spans[this.track]; }
  get atEnd(): boolean { return this.t >= this.span.to; }

  seek(t: number, track: Track = this.track): void {
    const { from, to } = this.spans[track];
    this.now[track] = Math.min(Math.max(t, from), to);
  }

  play(playing: boolean): void {
    if (playing && this.atEnd) this.seek(this.span.from);
    this.playing = playing;
    this.steps = [];
  }

  /** One frame, `wall` seconds after the last. At the auction's end the mission takes off. */
  advance(wall: number): void {
    if (!this.playing) return;
    const shown = Math.min(wall, LONGEST_STEP_S);
    this.remember(wall, shown);
    this.seek(this.t + shown * this.rate[this.track]);
    if (!this.atEnd) return;
    const flies = this.spans.mission.to > this.spans.mission.from;
    if (this.track === 'auction' && flies) this.startOver('mission');
    else if (this.loop) this.startOver('auction');
    else this.playing = false;
  }

  private startOver(track: Track): void {
    this.track = track;
    this.seek(this.span.from);
    this.steps = [];
  }

  private remember(wall: number, shown: number): void {
    this.steps.push({ wall, shown });
    let total = this.steps.reduce((sum, step) => sum + step.wall, 0);
    while (this.steps.length > 1 && total - this.steps[0].wall >= MEASURED_S) total -= this.steps.shift()!.wall;
  }

  /** What was really shown of each second lately, in units of time of the track. */
  get realRate(): number {
    const wall = this.steps.reduce((sum, step) => sum + step.wall, 0);
    const shown = this.steps.reduce((sum, step) => sum + step.shown, 0);
    return wall > 0 ? (this.rate[this.track] * shown) / wall : this.rate[this.track];
  }

  get fallsBehind(): boolean { return this.playing && this.realRate < 0.95 * this.rate[this.track]; }
}
