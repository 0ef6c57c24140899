// SPDX-License-Identifier: GPL-3.0-or-later
// What the structure's colours mean, over the scene; each entry is a button that lets its samples stand out.
import type { App, Part } from '../app';
import { h, svg } from '../dom';
import { legendOf, type Entry } from '../model/colouring';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';

const TITLE = { plain: '', coverage: 'Samples by coverage', redundancy: 'Samples by redundancy' };

export class Legend implements Part {
  private readonly title = h('p', { class: 'dim' });
  private readonly list = h('ul', { 'aria-label': 'Colours of the structure; Enter lets one stand out' });
  private readonly place = h('div', { id: 'legend', hidden: true }, this.title, this.list);
  private drawn = '';

  constructor(private readonly app: App, stage: HTMLElement) { stage.append(this.place); }

  show(_: ViewModel): void { this.drawn = ''; }

  update({ model, colouring, dark, only }: Snapshot): void {
    const samples = model.data.coverage?.samples;
    this.place.hidden = !samples || colouring === 'plain';
    const key = `${colouring} ${dark}`;
    if (samples && key !== this.drawn) {
      this.drawn = key;
      this.title.textContent = TITLE[colouring];
      this.list.replaceChildren(...legendOf(samples, colouring, dark).map((entry, i) => h('li', {}, this.button(entry, i))));
    }
    this.list.querySelectorAll('button').forEach((button, i) => button.setAttribute('aria-pressed', String(i === only)));
  }

  private button({ name, css, count }: Entry, place: number): HTMLElement {
    const colour = svg('svg', { class: 'swatch', width: 12, height: 12, viewBox: '0 0 12 12', 'aria-hidden': 'true' },
      svg('rect', { width: 12, height: 12, rx: 2, fill: css }));
    return h('button', { onclick: () => this.app.chooseOnly(place) }, colour, h('span', {}, name), h('span', { class: 'count' }, count.toLocaleString('en')));
  }
}
