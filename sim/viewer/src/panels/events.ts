// SPDX-License-Identifier: GPL-3.0-or-later
// What happened, as a list to go through by key.
import type { App, Part } from '../app';
import { eventMark } from '../event_marks';
import { h, panel } from '../dom';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';

export class EventPanel implements Part {
  private readonly list = h('ul', { class: 'events', id: 'events', 'aria-label': 'Events; Enter goes to one' });
  private items: { t_s: number; element: HTMLElement }[] = [];
  private current = -2;

  constructor(private readonly app: App, place: HTMLElement) {
    place.append(panel('Events', this.list));
    this.list.addEventListener('keydown', (event) => this.key(event));
  }

  show(model: ViewModel): void {
    this.current = -2;
    const focused = this.items.findIndex(({ element }) => element.contains(document.activeElement));
    this.items = model.events.map(({ t_s, kind, text }, i) => {
      const button = h('button', { tabindex: i === 0 ? 0 : -1, onclick: () => this.app.seek(t_s, 'auction') },
        eventMark(kind), h('time', {}, `${t_s.toFixed(3)} s`), h('span', {}, text));
      return { t_s, element: h('li', {}, button) };
    });
    this.list.replaceChildren(...this.items.map((item) => item.element));
    if (focused >= 0) this.focus(Math.min(focused, this.items.length - 1));
  }

  update(now: Snapshot): void {
    let current = -1;
    this.items.forEach((item, i) => { if (item.t_s <= now.t) current = i; });
    if (current === this.current) return;
    this.current = current;
    this.items.forEach((item, i) => {
      item.element.classList.toggle('ahead', i > current);
      item.element.classList.toggle('newest', i === current);
    });
    const element = this.items[current]?.element;
    if (element && !this.list.contains(document.activeElement)) this.list.scrollTop = element.offsetTop - this.list.offsetTop - 40;
  }

  private focus(i: number): void {
    this.items.forEach(({ element }, k) => element.querySelector('button')!.setAttribute('tabindex', k === i ? '0' : '-1'));
    this.items[i]?.element.querySelector('button')!.focus();
  }

  private key(event: KeyboardEvent): void {
    const at = this.items.findIndex(({ element }) => element.contains(document.activeElement));
    const last = this.items.length - 1;
    const goes: Record<string, number> = { ArrowUp: at - 1, ArrowDown: at + 1, Home: 0, End: last };
    if (at < 0 || !(event.key in goes)) return;
    event.preventDefault();
    event.stopPropagation();
    this.focus(Math.min(Math.max(goes[event.key], 0), last));
  }
}
