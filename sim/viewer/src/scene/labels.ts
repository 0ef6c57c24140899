// SPDX-License-Identifier: GPL-3.0-or-later
// Text over the scene: no owner is shown by colour alone.

export interface Label { x: number; y: number; text: string; css: string; strong: boolean; pin?: { x: number; y: number } }

const HEIGHT = 16;
const FONT = '600 11px system-ui, sans-serif';

/** Text is measured once: asking for it took longer than all else in a frame. */
const widths = new Map<string, number>();

function widthOf(context: CanvasRenderingContext2D, text: string): number {
  let width = widths.get(text);
  if (width === undefined) widths.set(text, (width = context.measureText(text).width + 10));
  return width;
}

interface Taken { x: number; y: number; width: number }

function hasRoom(taken: Taken[], { x, y }: Label, width: number): boolean {
  for (const other of taken)
    if (Math.abs(other.y - y) < HEIGHT + 4 && Math.abs(other.x - x) < (other.width + width) / 2 + 6) return false;
  return true;
}

/** The place that a label speaks of. */
function drawPin(context: CanvasRenderingContext2D, { x, y }: { x: number; y: number }, { css, strong }: Label, ink: string, paper: string): void {
  context.beginPath();
  context.arc(x, y, strong ? 7 : 5, 0, 2 * Math.PI);
  for (const [colour, width] of [[paper, 5], [css, 2.5]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke();
  }
  context.fillStyle = ink;
  context.fillRect(x - 1, y - 1, 2, 2);
}

/** Draws those that fit without lying on each other; strong ones go first. */
export function drawLabels(canvas: HTMLCanvasElement, labels: Label[], pixel: number, ink: string, paper: string): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  context.setTransform(pixel, 0, 0, pixel, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.font = FONT;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const taken: Taken[] = [];
  for (const label of [...labels].sort((a, b) => Number(b.strong) - Number(a.strong))) {
    if (label.pin) drawPin(context, label.pin, label, ink, paper);
    const width = widthOf(context, label.text);
    if (!label.strong && !hasRoom(taken, label, width)) continue;
    taken.push({ x: label.x, y: label.y, width });
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
