// SPDX-License-Identifier: GPL-3.0-or-later
// The newest round: which pieces changed hands or price in it.
import type { App, Part } from '../app';
import { h, panel, setText, swatch } from '../dom';
import { roundReport, type Claim, type PieceChange } from '../model/rounds';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';
import { bidText } from '../text';

/** More rows than anybody reads are only counted. */
const MOST_ROWS = 100;

export class RoundPanel implements Part {
  private readonly head = h('p', { class: 'facts', id: 'round-facts' });
  private readonly body = h('tbody');
  private readonly table = h('div', { class: 'scroll' });
  private drawn = '';

  constructor(private readonly app: App, place: HTMLElement) {
    const names = h('tr', {}, ...['piece', 'held', 'now', 'bid'].map((name) => h('th', { scope: 'col' }, name)));
    place.append(panel('Bids and winners', this.head, this.table));
    this.table.append(h('table', {}, h('thead', {}, names), this.body));
  }

  show(): void { this.drawn = ''; }

  update(now: Snapshot): void {
    const key = `${now.t} ${now.dark} ${now.slot}`;
    if (key === this.drawn) return;
    this.drawn = key;
    const report = roundReport(now.model, now.t);
    const { length } = report.changes;
    setText(this.head, report.deciders === 0 ? 'Nobody has bid yet.'
      : `Round ${report.round}: ${report.deciders} decided, ${length} ${length === 1 ? 'piece' : 'pieces'} changed`
        + (length > MOST_ROWS ? ` (${MOST_ROWS} shown)` : ''));
    this.head.title = `since ${report.from_s.toFixed(6)} s`;
    this.table.hidden = length === 0;
    this.body.replaceChildren(...report.changes.slice(0, MOST_ROWS).map((change) => this.row(now, change)));
  }

  private row(now: Snapshot, { slot, before, after }: PieceChange): HTMLElement {
    const { task } = now.model.tasks[slot];
    const choose = h('button', { class: 'link', onclick: () => this.app.chooseTask(task) }, String(task));
    return h('tr', { class: slot === now.slot ? 'own' : '' }, h('th', { scope: 'row' }, choose),
      this.holder(now.model, before, now.dark), this.holder(now.model, after, now.dark), h('td', {}, bidText(after.bid)));
  }

  private holder(model: ViewModel, { owner }: Claim, dark: boolean): HTMLElement {
    return h('td', {}, ...(owner < 0 ? ['–'] : [swatch(model.agentSlot(owner), dark), ` ${owner}`]));
  }
}
