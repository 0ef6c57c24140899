// SPDX-License-Identifier: GPL-3.0-or-later
// How things are said.
import { isTooNear, type Figures, type Nearest } from './model/coverage';
import type { Track } from './model/clock';
import type { ViewModel } from './model/view_model';

export const agentName = (model: ViewModel, owner: number): string =>
  model.agentSlot(owner) < 0 ? (owner < 0 ? 'nobody' : `agent ${owner}?`) : `agent ${owner}`;

export function pieceName(model: ViewModel, slot: number, owner: number): string {
  const { task, arc } = model.tasks[slot];
  return `piece ${task} · arc ${arc} · ${agentName(model, owner)}`;
}

export const bidText = (bid: number): string => (Number.isFinite(bid) ? bid.toPrecision(6).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '') : '–');

export function timeText(track: Track, t: number): string {
  if (track === 'auction') return `${t.toFixed(3)} s`;
  const minutes = Math.floor(t / 60), seconds = t - 60 * minutes;
  return `${minutes}:${seconds.toFixed(1).padStart(4, '0')} min`;
}

export const clearanceText = (nearest: Nearest, figures: Figures | undefined): string =>
  `${nearest.distance_m.toFixed(2)} m${isTooNear(nearest, figures) ? ` < ${figures!.safety_m} m` : ''}`;

/** Never 100 % of what is not all. */
export const shareText = (share: number): string => `${(Math.floor(share * 1e5) / 1e3).toFixed(share >= 0.99 && share < 1 ? 3 : 1)} %`;

export const rateText = (rate: number): string => `${Number(rate.toPrecision(2))}×`;
