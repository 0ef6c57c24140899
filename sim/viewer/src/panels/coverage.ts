// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate: how much was seen, why the rest was not, and how near each agent comes to the structure.
import type { App, Part } from '../app';
import { h, panel, setText } from '../dom';
import { isTooNear, type Clearance, type Coverage, type Figures } from '../model/coverage';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';
import { clearanceText, shareText } from '../text';

const counted = (count: number): string => count.toLocaleString('en');

export class CoveragePanel implements Part {
  private readonly problem = h('p', { class: 'warning', id: 'coverage-problem' });
  private readonly figures = h('dl', { class: 'figures', id: 'coverage-figures' });
  private readonly reasons = h('div', { id: 'uncovered' });
  private readonly clearances = h('ul', { class: 'clearances', id: 'clearances', 'aria-label': 'Least clearance of each agent; Enter goes there' });
  private readonly place = panel('Coverage', this.problem, this.figures, this.reasons, this.clearances);

  constructor(private readonly app: App, place: HTMLElement) { place.append(this.place); }

  show({ data: { coverage } }: ViewModel): void {
    this.place.hidden = coverage === undefined;
    if (!coverage) return;
    this.problem.hidden = coverage.problem === '';
    setText(this.problem, coverage.problem);
    this.figures.replaceChildren(...(coverage.figures ? figureRows(coverage.figures) : []));
    this.reasons.replaceChildren(...(coverage.uncovered.length > 0 ? [reasonTable(coverage)] : []));
    this.clearances.replaceChildren(...coverage.clearance.map((one) => h('li', {}, this.clearance(one, coverage.figures))));
  }

  update(now: Snapshot): void {
    for (const button of this.clearances.querySelectorAll('button'))
      button.setAttribute('aria-pressed', String(Number(button.dataset.agent) === now.mark));
  }

  private clearance({ agent, nearest }: Clearance, figures: Figures | undefined): HTMLElement {
    if (!nearest) return h('span', { class: 'dim' }, `agent ${agent}: not flown`);
    const near = isTooNear(nearest, figures);
    return h('button', { class: near ? 'near' : '', 'data-agent': agent, title: 'To that place (M)', onclick: () => this.app.goToMark(agent) },
      h('span', {}, `agent ${agent}`), h('b', {}, clearanceText(nearest, figures)), h('span', { class: 'dim' }, `leg ${nearest.leg}`));
  }
}

function figureRows(figures: Figures): HTMLElement[] {
  const { covered_samples, covered_visible_samples, visible_samples, surface_samples, spacing_m, metres_per_m2, flown_m, safety_m } = figures;
  const rows: [string, string][] = [
    ['covered of visible', `${shareText(figures.coverage_of_visible)} · ${counted(covered_visible_samples)} of ${counted(visible_samples)}`],
    ['covered of total', `${shareText(figures.coverage_of_total)} · ${counted(covered_samples)} of ${counted(surface_samples)}`],
    ['samples', `${counted(surface_samples)} sides, spacing ${spacing_m.toFixed(2)} m`],
    ['flown', `${flown_m.toFixed(0)} m, ${metres_per_m2.toFixed(3)} m per m²`],
    ['safety distance', `${safety_m} m`],
  ];
  if (figures.below_floor_m > 0) rows.push(['below the floor', `${figures.below_floor_m.toFixed(1)} m flown`]);
  return rows.flatMap(([label, value]) => [h('dt', {}, label), h('dd', {}, value)]);
}

function reasonTable({ uncovered }: Coverage): HTMLElement {
  const rows = uncovered.map(({ reason, count }) => h('tr', {}, h('th', { scope: 'row' }, reason), h('td', {}, counted(count))));
  return h('table', {}, h('caption', {}, 'Not covered, by reason'), h('tbody', {}, ...rows));
}
