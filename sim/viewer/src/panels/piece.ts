// SPDX-License-Identifier: GPL-3.0-or-later
// The chosen piece of an arc: whose it is, who bids what for it, and why.
import type { App, Part } from '../app';
import { h, panel, swatch } from '../dom';
import { stancesOn, type Stance } from '../model/rounds';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';
import { agentName, bidText } from '../text';

export class PiecePanel implements Part {
  private readonly picker = h('select', { id: 'piece', 'aria-label': 'Piece to explain' });
  private readonly facts = h('p', { class: 'facts', id: 'piece-facts' });
  private readonly bids = h('div', { class: 'bids' });
  private readonly story = h('ol', { class: 'story', id: 'explanation', 'aria-label': 'Why the piece changed hands' });
  private drawn = '';

  constructor(private readonly app: App, place: HTMLElement) {
    this.picker.addEventListener('change', () => app.chooseTask(this.picker.value === '' ? null : Number(this.picker.value)));
    place.append(panel('Piece', this.picker, this.facts, this.story, this.bids));
  }

  show(model: ViewModel): void {
    this.drawn = '';
    const options = model.tasks.map(({ task, arc, from_m, to_m }) =>
      h('option', { value: task }, `piece ${task} · arc ${arc}, ${from_m.toFixed(1)}–${to_m.toFixed(1)} m`));
    this.picker.replaceChildren(h('option', { value: '' }, 'click an arc, or choose a piece here'), ...options);
  }

  update(now: Snapshot): void {
    const { model, slot } = now;
    this.picker.value = slot < 0 ? '' : String(model.tasks[slot].task);
    const key = slot < 0 ? 'none' : JSON.stringify([slot, now.t, now.perspective, now.dark, model.data.auction.decisions.length]);
    if (key === this.drawn) return;
    this.drawn = key;
    if (slot < 0) {
      for (const part of [this.facts, this.bids, this.story]) part.replaceChildren();
      return;
    }
    this.tellFacts(now, slot);
    this.tellBids(now, slot);
    this.tellStory(now, slot);
  }

  private tellFacts(now: Snapshot, slot: number): void {
    const { model, owners } = now;
    const { arc, from_m, to_m } = model.tasks[slot];
    const kind = model.data.arcs.find((one) => one.arc === arc)?.kind ?? '';
    const owner = owners[slot];
    this.facts.replaceChildren(
      swatch(model.agentSlot(owner), now.dark), h('b', {}, ` ${agentName(model, owner)}`),
      ` · arc ${arc}${kind && ` (${kind.replace('_', ' ')})`}, ${(to_m - from_m).toFixed(1)} m`,
      ...(now.disputed[slot] ? [h('span', { class: 'disputed' }, 'disputed')] : []),
    );
  }

  private tellBids(now: Snapshot, slot: number): void {
    const stances = stancesOn(now.model, slot, now.t);
    const rows = stances.map((stance) => this.bidRow(now, stance));
    const head = h('tr', {}, ...['agent', 'its bid', 'believes', 'at'].map((name) => h('th', { scope: 'col' }, name)));
    this.bids.replaceChildren(h('table', {}, h('caption', {}, 'Bids and beliefs now'), h('thead', {}, head), h('tbody', {}, ...rows)));
  }

  private bidRow({ model }: Snapshot, { agent, state, bid, believes }: Stance): HTMLElement {
    const own = Number.isNaN(bid) ? '–' : bidText(bid);
    return h('tr', { class: state === 'dead' ? 'dead' : believes.owner === agent ? 'own' : '' },
      h('th', { scope: 'row' }, String(agent)), h('td', {}, own),
      h('td', {}, state === 'dead' ? '✕' : agentName(model, believes.owner)), h('td', {}, bidText(believes.bid)));
  }

  private tellStory(now: Snapshot, slot: number): void {
    const said = now.model.data.explanations.get(now.model.tasks[slot].task) ?? [];
    let newest: HTMLElement | undefined;
    const lines = said.map(({ t_s, text }) => {
      const past = t_s <= now.t;
      const button = h('button', { onclick: () => this.app.seek(t_s, 'auction') }, h('time', {}, `${t_s.toFixed(3)} s`), ` ${text}`);
      const line = h('li', { class: past ? 'past' : 'ahead' }, button);
      if (past) newest = line;
      return line;
    });
    newest?.classList.add('newest');
    this.story.replaceChildren(...(lines.length > 0 ? lines : [h('li', { class: 'ahead' }, 'Nothing was recorded about this piece.')]));
    if (newest) this.story.scrollTop = newest.offsetTop - 24;
  }
}
