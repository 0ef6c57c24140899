// SPDX-License-Identifier: GPL-3.0-or-later
import { DASHES, lookOf, nobodysLook } from './model/palette';

type Child = Node | string;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** An element; `on…` attributes are listeners, true and false set and leave out. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else if (value !== false) element.setAttribute(name, value === true ? '' : String(value));
  element.append(...children);
  return element;
}

export function svg(tag: string, attributes: Record<string, string | number>, ...children: Node[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** A stroke as the agent's arcs have it; the text beside it says whose it is. */
export function swatch(slot: number, dark: boolean): SVGElement {
  const look = slot < 0 ? nobodysLook(dark) : lookOf(slot, dark);
  const line = svg('line', { x1: 1, y1: 5, x2: 23, y2: 5, stroke: look.css, 'stroke-width': 5, 'stroke-dasharray': DASHES[look.pattern].join(' ') });
  return svg('svg', { class: 'swatch', width: 24, height: 10, viewBox: '0 0 24 10', 'aria-hidden': 'true' }, line);
}

/** A panel that folds. */
export function panel(name: string, ...content: Child[]): HTMLDetailsElement {
  return h('details', { class: 'panel', open: true }, h('summary', {}, name), ...content);
}

export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Sizes a canvas to its place on the page; true when it has one. */
export function fitCanvas(canvas: HTMLCanvasElement): CanvasRenderingContext2D | undefined {
  const pixel = Math.min(window.devicePixelRatio || 1, 2);
  const width = Math.round(canvas.clientWidth * pixel), height = Math.round(canvas.clientHeight * pixel);
  if (width === 0 || height === 0) return undefined;
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  const context = canvas.getContext('2d') ?? undefined;
  context?.setTransform(pixel, 0, 0, pixel, 0, 0);
  return context;
}

export const themeColour = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
