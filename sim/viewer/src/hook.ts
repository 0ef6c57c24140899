// SPDX-License-Identifier: GPL-3.0-or-later
// What tests and scripts ask of the page: window.arcbid.
import type { App } from './app';
import type { Track } from './model/clock';
import { marksOf } from './model/coverage';
import { middleOf } from './scene/label_choice';
import type { Theme, ThemeSwitch } from './theme';

export function hook(app: App, theme: ThemeSwitch): void {
  const drawn = (): Promise<void> => new Promise((done) => {
    app.changed();
    const before = app.frames;
    const wait = (): void => { if (app.frames > before) done(); else requestAnimationFrame(wait); };
    wait();
  });
  const api = {
    /** Resolves once all that was asked for before is on the screen. */
    drawn,
    seek: (t: number, track: Track) => { app.seek(t, track); return drawn(); },
    theme: (name: Theme) => { theme.set(name); return drawn(); },
    span: (track: Track) => ({ ...app.clock.spans[track] }),
    counts: () => ({ agents: app.model!.agents.length, arcs: app.model!.data.arcs.length, tasks: app.model!.tasks.length }),
    state: () => {
      const now = app.snapshot();
      return {
        track: now.track, t: now.track === 'auction' ? now.t : now.flight_s, playing: app.clock.playing, task: app.task, agent: app.agent,
        perspective: now.perspective, colouring: now.colouring, only: now.only, mark: now.mark, target: app.scene.camera.target, owners: [...now.owners], disputes: now.disputes, dark: now.dark, drawCalls: app.scene.drawCalls,
        frames: app.frames, drones: app.model!.agents.map((agent) => app.model!.mission.placeOf(agent, now.flight_s).position),
      };
    },
    /** Where in the window an agent's nearest place to the structure is. */
    findMark: (agent: number) => {
      const mark = marksOf(app.model!.data.coverage).find((one) => one.agent === agent);
      const at = mark && app.scene.project(mark.nearest.at_m);
      const box = document.getElementById('scene')!.getBoundingClientRect();
      return at && { x: at.x + box.left, y: at.y + box.top };
    },
    /** Where in the window the middle of a piece is, and which piece a click there would choose. */
    find: (slot: number) => {
      const at = app.scene.project(middleOf(app.model!.tasks[slot].line));
      const box = document.getElementById('scene')!.getBoundingClientRect();
      return at && { x: at.x + box.left, y: at.y + box.top, slot: app.scene.pieceAt(at.x, at.y) };
    },
  };
  Object.assign(window, { arcbid: api });
}
