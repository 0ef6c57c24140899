// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and pen on the scene: point at a piece to name it, click to have it explained, click a mark to go there.
import type { App } from './app';

/** A press that moves farther than this turns the view. */
const STILL_PX = 4;

export function pointAt(app: App, canvas: HTMLCanvasElement): void {
  let down: [number, number] | undefined;
  canvas.addEventListener('pointerdown', (event) => { down = [event.offsetX, event.offsetY]; app.hover(-1); });
  canvas.addEventListener('pointerup', (event) => {
    const still = down && Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) <= STILL_PX;
    down = undefined;
    if (!still || !app.model || event.button !== 0) return;
    const mark = app.scene.markAt(event.offsetX, event.offsetY, app.snapshot());
    if (mark !== undefined) { app.goToMark(mark); return; }
    const slot = app.scene.pieceAt(event.offsetX, event.offsetY);
    app.chooseTask(slot < 0 ? null : app.model.tasks[slot].task);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons === 0) app.hover(app.scene.pieceAt(event.offsetX, event.offsetY));
  });
  canvas.addEventListener('pointerleave', () => app.hover(-1));
}
