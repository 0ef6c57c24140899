// SPDX-License-Identifier: GPL-3.0-or-later
// All that is shown at one moment, worked out once for every part of the page.
import type { Colouring } from './model/colouring';
import type { Track } from './model/clock';
import type { Perspective, ViewModel } from './model/view_model';

export interface Snapshot {
  model: ViewModel;
  track: Track;
  /** The auction's time: its end while drones fly. */
  t: number;
  flight_s: number;
  dark: boolean;
  labels: boolean;
  perspective: Perspective;
  owners: Float64Array;
  disputed: Uint8Array;
  disputes: number;
  /** The chosen piece and the one under the pointer, by place in the list of tasks; -1: none. */
  slot: number;
  hover: number;
  /** The agent whose pieces are to stand out. */
  agent: number | null;
  /** What the structure's colours mean, which of its legend stands out, and whose nearest place to it does. */
  colouring: Colouring;
  only: number | null;
  mark: number | null;
  alive(agent: number): boolean;
}
