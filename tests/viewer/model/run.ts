// SPDX-License-Identifier: GPL-3.0-or-later
// Small runs for tests.
import { normalise } from '../../../sim/viewer/src/model/data';
import { ViewModel } from '../../../sim/viewer/src/model/view_model';

const agents = (count: number): object[] => Array.from({ length: count }, (_, i) => ({ agent: i + 1, home: [i, 0, 0], speed_mps: 2 }));
const tasks = (count: number): object[] =>
  Array.from({ length: count }, (_, i) => ({ task: 10 + i, arc: 0, from_m: 2 * i, to_m: 2 * i + 2, line: [2 * i, 0, 5, 2 * i + 2, 0, 5] }));

/** Three agents and three pieces (10, 11, 12) of 2 m each, and what `auction` says of them. */
export const run = (auction: object, more: object = {}): ViewModel =>
  new ViewModel(normalise({ schema: 1, agents: agents(3), tasks: tasks(3), auction, ...more }));

export const decision = (t_s: number, agent: number, bundle: number[], round = 1): object => ({ t_s, agent, round, changed: true, bundle });
