// SPDX-License-Identifier: GPL-3.0-or-later
// Text over the scene: no owner is shown by colour alone.

export interface Label { x: number; y: number; text: string; css: string; strong: boolean }

const HEIGHT = 16;

/** Draws those that fit without lying on each other; strong ones go first. */
export function drawLabels(canvas: HTMLCanvasElement, labels: Label[], pixel: number, ink: string, paper: string): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  context.setTransform(pixel, 0, 0, pixel, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.font = '600 11px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const taken: [number, number, number][] = [];
  for (const label of [...labels].sort((a, b) => Number(b.strong) - Number(a.strong))) {
    const width = context.measureText(label.text).width + 10;
    const room = !label.strong;
    if (room && taken.some(([x, y, w]) => Math.abs(x - label.x) < (w + width) / 2 + 6 && Math.abs(y - label.y) < HEIGHT + 4)) continue;
    taken.push([label.x, label.y, width]);
    context.beginPath();
    context.roundRect(label.x - width / 2, label.y - HEIGHT / 2, width, HEIGHT, 4);
    context.fillStyle = paper;
    context.globalAlpha = label.strong ? 0.95 : 0.8;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = label.strong ? 2 : 1;
    context.strokeStyle = label.css;
    context.stroke();
    context.fillStyle = ink;
    context.fillText(label.text, label.x, label.y + 0.5);
  }
}
