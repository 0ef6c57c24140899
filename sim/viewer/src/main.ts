// SPDX-License-Identifier: GPL-3.0-or-later
import { App } from './app';
import { Header } from './header';
import { hook } from './hook';
import { Keys } from './keys';
import { embedded, follow, served } from './load';
import { CoveragePanel } from './panels/coverage';
import { EventPanel } from './panels/events';
import { Legend } from './panels/legend';
import { LinkPanel } from './panels/link_matrix';
import { LoadPanel } from './panels/load';
import { PiecePanel } from './panels/piece';
import { RoundPanel } from './panels/round';
import { pointAt } from './pointing';
import { ThemeSwitch } from './theme';
import { Timeline } from './timeline';

const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

function fail(problem: unknown): void {
  const message = byId('message');
  message.textContent = problem instanceof Error ? problem.message : String(problem);
  message.hidden = false;
  document.documentElement.dataset.ready = 'failed';
}

function build(): { app: App; header: Header } {
  const canvas = byId<HTMLCanvasElement>('scene');
  const app = new App(canvas, byId<HTMLCanvasElement>('overlay'));
  const header: Header = new Header(app, byId('title'), byId('switches'), { theme: () => theme.next(), help: () => keys.help() });
  const theme: ThemeSwitch = new ThemeSwitch(app, (chosen) => header.tellTheme(chosen));
  const keys: Keys = new Keys(app, byId('help-place'), () => theme.next());
  const panels = byId('panels');
  const parts = [header, new LoadPanel(app, panels), new CoveragePanel(app, panels), new LinkPanel(app, panels),
    new PiecePanel(app, panels), new RoundPanel(app, panels), new EventPanel(app, panels), new Legend(app, byId('stage')), new Timeline(app, byId('timeline'))];
  for (const part of parts) app.add(part);
  pointAt(app, canvas);
  theme.apply();
  hook(app, theme);
  return { app, header };
}

async function begin(): Promise<void> {
  const { app, header } = build();
  const own = await embedded();
  app.load(own ?? (await served()));
  if (!own) follow((data) => app.load(data), (liveness) => header.tellLiveness(liveness));
  document.documentElement.dataset.ready = 'yes';
}

begin().catch(fail);
