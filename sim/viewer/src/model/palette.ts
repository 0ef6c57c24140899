// SPDX-License-Identifier: GPL-3.0-or-later
// One look for each agent. Okabe and Ito (2008) chose eight colours that every kind of colour
// vision tells apart; further agents get them again with other dashes, then in another lightness.

export type Rgb = [number, number, number];
export interface Look { rgb: Rgb; css: string; pattern: number }

const LIGHT = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#1c1c1c', '#f0e442'];
const DARK = ['#3d94d6', '#e69f00', '#00b083', '#d68cb4', '#7cc8f2', '#e8691b', '#f2f2f2', '#f0e442'];

export const PATTERNS = 4;
/** Dashes for strokes of charts and swatches, by pattern; those of the scene are in its shader. */
export const DASHES: number[][] = [[], [7, 3], [2, 3], [9, 3, 2, 3]];

export const rgbOf = (hex: string): Rgb => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as Rgb;
const cssOf = (rgb: Rgb): string => '#' + rgb.map((v) => Math.round(v).toString(16).padStart(2, '0')).join('');

export function lookOf(slot: number, dark: boolean): Look {
  const hues = dark ? DARK : LIGHT;
  const level = Math.floor(slot / hues.length);
  const base = rgbOf(hues[slot % hues.length]);
  const shade = Math.min(Math.floor(level / PATTERNS), 1);
  const towards = dark ? 255 : 0;
  const rgb = base.map((v) => v + (towards - v) * 0.4 * shade) as Rgb;
  return { rgb, css: cssOf(rgb), pattern: level % PATTERNS };
}

/** What belongs to nobody. */
export const nobodysLook = (dark: boolean): Look => {
  const rgb: Rgb = dark ? [112, 120, 130] : [138, 144, 152];
  return { rgb, css: cssOf(rgb), pattern: 0 };
};
