// SPDX-License-Identifier: GPL-3.0-or-later
// What run this is, and the switches over the scene.
import type { App, Part } from './app';
import { h, setText } from './dom';
import type { Liveness } from './load';
import { COLOURINGS, type Colouring } from './model/colouring';
import type { Theme } from './theme';
import type { ViewModel } from './model/view_model';
import type { Snapshot } from './snapshot';

const LIVENESS: Record<Liveness, string> = { live: '● live', lost: '○ connection lost, trying again', ended: '■ the run has ended' };

export class Header implements Part {
  private readonly name = h('h1');
  private readonly run = h('p', { class: 'dim' });
  private readonly live = h('p', { id: 'live', role: 'status' });
  private readonly summary = h('dl', { id: 'summary' });
  private readonly view = h('select', { id: 'perspective', 'aria-label': 'Whose view of the owners' });
  private readonly colouring = h('select', { id: 'colouring', title: 'Colours of the structure (C)' }, ...COLOURINGS.map((one) => h('option', { value: one }, one)));
  private readonly colours = h('label', { hidden: true }, 'Structure ', this.colouring);
  private readonly theme = h('button', { id: 'theme', title: 'Light, dark, or as the system has it (T)' });
  private readonly disputes = h('p', { id: 'disputes' });

  constructor(private readonly app: App, title: HTMLElement, switches: HTMLElement, act: { theme(): void; help(): void }) {
    title.append(this.name, this.run, this.live, h('details', { open: true }, h('summary', {}, 'Run'), this.summary));
    this.view.addEventListener('change', () => {
      app.perspective = this.view.value === 'fleet' ? 'fleet' : Number(this.view.value);
      app.changed();
    });
    this.colouring.addEventListener('change', () => app.colour(this.colouring.value as Colouring));
    this.theme.addEventListener('click', act.theme);
    const labels = h('button', { title: 'Owners beside the arcs (L)', onclick: () => { app.labels = !app.labels; app.changed(); } }, 'Labels');
    const fit = h('button', { title: 'Fit into view (F)', onclick: () => { app.scene.camera.fit(); app.changed(); } }, 'Fit');
    const help = h('button', { title: 'Keys (?)', 'aria-label': 'Keys', onclick: act.help }, '?');
    switches.append(h('label', {}, 'Owners ', this.view), this.colours, labels, fit, this.theme, help, this.disputes);
  }

  show({ data, agents }: ViewModel): void {
    setText(this.name, data.name || 'arcbid');
    setText(this.run, [data.run, [data.build.version, data.build.commit].filter(Boolean).join(' ')].filter(Boolean).join(' · '));
    document.title = `${data.name || 'run'} – arcbid`;
    this.summary.replaceChildren(...data.summary.flatMap(([label, value]) => [h('dt', {}, label), h('dd', {}, value)]));
    this.colours.hidden = !data.coverage?.samples;
    this.view.replaceChildren(h('option', { value: 'fleet' }, 'as the fleet decided'),
      ...agents.map((agent) => h('option', { value: agent }, `as agent ${agent} sees them`)));
  }

  update(now: Snapshot): void {
    this.view.value = String(this.app.perspective);
    this.colouring.value = now.colouring;
    const { disputes } = now;
    setText(this.disputes, disputes === 0 ? '' : `${disputes} ${disputes === 1 ? 'piece' : 'pieces'} disputed`);
  }

  tellTheme(theme: Theme): void { setText(this.theme, { system: 'Auto', light: 'Light', dark: 'Dark' }[theme]); }

  tellLiveness(liveness: Liveness): void {
    this.live.dataset.state = liveness;
    setText(this.live, LIVENESS[liveness]);
  }
}
