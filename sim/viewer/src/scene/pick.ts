// SPDX-License-Identifier: GPL-3.0-or-later
// Which stroke is under the pointer: the nearest on the screen, of those about as near the nearest to the eye.
import * as THREE from 'three';
import type { FatLines } from './fat_lines';

const REACH_PX = 9;

export class Picker {
  private readonly matrix = new THREE.Matrix4();
  constructor(private readonly lines: FatLines) {}

  /** -1: none. `x`, `y`, `width` and `height` in CSS pixels. */
  at(camera: THREE.PerspectiveCamera, x: number, y: number, width: number, height: number): number {
    this.matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const a = new THREE.Vector4(), b = new THREE.Vector4();
    const { firsts, starts, ends } = this.lines;
    let best = -1, bestScore = Infinity;
    for (let stroke = 0; stroke + 1 < firsts.length; stroke++)
      for (let s = firsts[stroke]; s < firsts[stroke + 1]; s++) {
        a.set(starts[3 * s], starts[3 * s + 1], starts[3 * s + 2], 1).applyMatrix4(this.matrix);
        b.set(ends[3 * s], ends[3 * s + 1], ends[3 * s + 2], 1).applyMatrix4(this.matrix);
        if (a.w <= 0.01 || b.w <= 0.01) continue;
        const [gap, depth] = nearest(a, b, x, y, width, height);
        // A pixel counts as much as a hundredth of the way: the line in front wins where two meet.
        const score = gap + 100 * depth;
        if (gap <= REACH_PX && score < bestScore) { best = stroke; bestScore = score; }
      }
    return best;
  }
}

function nearest(a: THREE.Vector4, b: THREE.Vector4, x: number, y: number, width: number, height: number): [number, number] {
  const ax = (a.x / a.w + 1) * 0.5 * width, ay = (1 - a.y / a.w) * 0.5 * height;
  const bx = (b.x / b.w + 1) * 0.5 * width, by = (1 - b.y / b.w) * 0.5 * height;
  const dx = bx - ax, dy = by - ay;
  const part = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / Math.max(dx * dx + dy * dy, 1e-9), 0), 1);
  const depth = Math.log(a.w + (b.w - a.w) * part);
  return [Math.hypot(x - ax - part * dx, y - ay - part * dy), depth];
}
