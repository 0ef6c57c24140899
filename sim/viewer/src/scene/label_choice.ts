// SPDX-License-Identifier: GPL-3.0-or-later
// Which labels stand in the scene: every drone's, the chosen piece's, and an owner's for each run of its pieces.
import { isTooNear, marksOf, type Nearest } from '../model/coverage';
import { lookOf, nobodysLook } from '../model/palette';
import { clearanceText, pieceName } from '../text';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';
import type { Label } from './labels';

type Project = (at: ArrayLike<number>) => { x: number; y: number } | undefined;

export function middleOf(line: number[]): number[] {
  const k = Math.max(Math.floor((line.length / 3 - 1) / 2), 0);
  const next = Math.min(k + 1, line.length / 3 - 1);
  return [0, 1, 2].map((axis) => (line[3 * k + axis] + line[3 * next + axis]) / 2);
}

export function labelsOf(model: ViewModel, now: Snapshot, project: Project): Label[] {
  const labels: Label[] = [];
  const cssOf = (agent: number): string =>
    model.agentSlot(agent) < 0 ? nobodysLook(now.dark).css : lookOf(model.agentSlot(agent), now.dark).css;
  for (const { agent } of model.data.agents) {
    const at = project(model.mission.placeOf(agent, now.flight_s).position);
    const alive = now.alive(agent);
    if (at) labels.push({ ...at, y: at.y - 20, text: alive ? `${agent}` : `${agent} ✕`, css: cssOf(agent), strong: true });
  }
  for (const slot of [now.slot, now.hover]) {
    const at = slot >= 0 && project(middleOf(model.tasks[slot].line));
    if (at) labels.push({ ...at, y: at.y - 16, text: pieceName(model, slot, now.owners[slot]), css: cssOf(now.owners[slot]), strong: true });
  }
  for (const { agent, nearest, at } of shownMarks(model, now, project)) {
    const near = isTooNear(nearest, model.data.coverage?.figures);
    const css = near ? (now.dark ? '#f0894f' : '#a8431a') : cssOf(agent);
    const strong = near || agent === now.mark;
    labels.push({ ...at, y: at.y - 18, pin: at, text: `${agent}: ${clearanceText(nearest, model.data.coverage?.figures)}`, css, strong });
  }
  if (now.labels && now.track === 'auction') labels.push(...ownersAlongArcs(model, now, project, cssOf));
  return labels;
}

/** Where agents come nearest to the structure: the chosen one's place, and all while its colours are looked at. */
export function shownMarks(model: ViewModel, now: Pick<Snapshot, 'colouring' | 'mark'>, project: Project):
    { agent: number; nearest: Nearest; at: { x: number; y: number } }[] {
  return marksOf(model.data.coverage).flatMap(({ agent, nearest }) => {
    const at = now.colouring !== 'plain' || agent === now.mark ? project(nearest.at_m) : undefined;
    return at ? [{ agent, nearest, at }] : [];
  });
}

/** One for each run of neighbouring pieces of one owner. */
function ownersAlongArcs(model: ViewModel, now: Snapshot, project: Project, cssOf: (agent: number) => string): Label[] {
  const labels: Label[] = [];
  const { tasks } = model;
  for (let first = 0, slot = 0; slot < tasks.length; slot++) {
    const next = tasks[slot + 1];
    if (next && next.arc === tasks[first].arc && now.owners[slot + 1] === now.owners[first]) continue;
    const owner = now.owners[first];
    const at = owner >= 0 && (now.agent === null || now.agent === owner) && project(middleOf(tasks[(first + slot) >> 1].line));
    if (at) labels.push({ ...at, text: `${owner}`, css: cssOf(owner), strong: false });
    first = slot + 1;
  }
  return labels;
}
