// SPDX-License-Identifier: GPL-3.0-or-later
// The foot of the page: play, pace, and the two tracks.
import type { App, Part } from './app';
import { h, setText } from './dom';
import { icon } from './icons';
import { RATES, type Track } from './model/clock';
import { disputeSeries, sampleTimes } from './model/series';
import type { ViewModel } from './model/view_model';
import type { Snapshot } from './snapshot';
import { moveToEvent, step } from './steps';
import { rateText } from './text';
import { TrackBar } from './track';

const SAMPLES = 300;
/** Kinds of which there is one for each agent: as marks they would hide the others. */
const MINOR = new Set(['route', 'refused', 'fault']);
const MOST_MINOR = 40;

export class Timeline implements Part {
  private readonly playButton = h('button', { id: 'play', class: 'play' });
  private readonly rate = h('select', { id: 'rate', 'aria-label': 'Pace' });
  private readonly real = h('span', { id: 'real-rate', class: 'warning', role: 'status' });
  private readonly loop = h('button', { id: 'loop', title: 'Loop', 'aria-label': 'Loop' }, icon('loop'));
  private readonly tracks: Record<Track, TrackBar>;
  private shownRates: Track | undefined;
  private playing: boolean | undefined;

  constructor(private readonly app: App, place: HTMLElement) {
    const bar = (track: Track, name: string): TrackBar => new TrackBar(track, name, (t) => app.seek(t, track), () => app.seek(app.clock.now[track], track));
    this.tracks = { auction: bar('auction', 'Auction'), mission: bar('mission', 'Mission') };
    this.playButton.addEventListener('click', () => app.play(!app.clock.playing));
    this.rate.addEventListener('change', () => { app.clock.rate[app.clock.track] = Number(this.rate.value); app.changed(); });
    this.loop.addEventListener('click', () => { app.clock.loop = !app.clock.loop; app.changed(); });
    const button = (name: string, title: string, act: () => void): HTMLElement => h('button', { title, 'aria-label': title, onclick: act }, icon(name));
    const controls = h('div', { class: 'controls', role: 'group', 'aria-label': 'Playback' },
      button('first', 'Previous event ( [ )', () => moveToEvent(app, -1)), button('back', 'Step back (←)', () => step(app, -1)), this.playButton,
      button('on', 'Step on (→)', () => step(app, 1)), button('last', 'Next event ( ] )', () => moveToEvent(app, 1)), this.loop, this.rate, this.real);
    place.append(controls, h('div', { class: 'tracks' }, this.tracks.auction.element, this.tracks.mission.element));
  }

  show(model: ViewModel): void {
    const { clock } = this.app;
    const minor = model.events.filter(({ kind }) => MINOR.has(kind)).length;
    const shown = model.events.filter(({ kind }) => minor <= MOST_MINOR || !MINOR.has(kind));
    const marks = shown.map(({ t_s, kind, text }) => ({ t_s, kind, title: `${t_s.toFixed(3)} s: ${text}` }));
    const times = sampleTimes(model, SAMPLES);
    this.tracks.auction.show(clock.spans.auction, marks, { times, values: disputeSeries(model, times), name: 'pieces disputed' });
    const landings = model.mission.landings().map(({ agent, t_s }) => ({ t_s, kind: 'end', title: `agent ${agent} is back after ${t_s.toFixed(1)} s` }));
    this.tracks.mission.show(clock.spans.mission, landings);
  }

  update(now: Snapshot): void {
    const { clock } = this.app;
    if (this.playing !== clock.playing) this.playButton.replaceChildren(icon(clock.playing ? 'pause' : 'play'));
    this.playing = clock.playing;
    this.playButton.setAttribute('aria-label', clock.playing ? 'Pause' : 'Play');
    this.loop.setAttribute('aria-pressed', String(clock.loop));
    if (this.shownRates !== clock.track) {
      this.shownRates = clock.track;
      this.rate.replaceChildren(...RATES[clock.track].map((rate) => h('option', { value: rate }, rateText(rate))));
    }
    this.rate.value = String(clock.rate[clock.track]);
    setText(this.real, clock.fallsBehind ? `really ${rateText(clock.realRate)}` : '');
    const { model } = now;
    const disputes = `round ${model.fleet.roundAt(now.t)} · ${now.disputes} disputed`;
    // While drones fly, what they were given is the auction's last word.
    this.tracks.auction.update(now.t, clock.track === 'auction', clock.track === 'auction' ? disputes : '');
    const flying = model.agents.filter((agent) => model.mission.placeOf(agent, clock.now.mission).flying).length;
    this.tracks.mission.update(clock.now.mission, clock.track === 'mission', model.mission.known ? `${flying} flying` : 'no routes yet');
  }
}
