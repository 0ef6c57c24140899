// SPDX-License-Identifier: GPL-3.0-or-later
// From one moment at which something happened to the next.
import type { App } from './app';
import { neighbour } from './model/search';

const MISSION_STEP_S = 1;

/** `count` moments of the auction, or seconds of the mission, on (back when negative). */
export function step(app: App, count: number): void {
  const { clock, model } = app;
  if (!model) return;
  if (clock.track === 'mission') { app.seek(clock.t + count * MISSION_STEP_S); return; }
  let t = clock.t;
  for (let i = 0; i < Math.abs(count); i++) t = neighbour(model.moments, t, count < 0 ? -1 : 1) ?? (count < 0 ? clock.span.from : clock.span.to);
  app.seek(t);
}

/** The next event in this direction: of the auction, or a landing. */
export function moveToEvent(app: App, direction: 1 | -1): void {
  const { clock, model } = app;
  if (!model) return;
  const events = clock.track === 'auction' ? model.events : model.mission.landings();
  const t = neighbour(events.map((event) => event.t_s), clock.t, direction);
  if (t !== undefined) app.seek(t);
}
