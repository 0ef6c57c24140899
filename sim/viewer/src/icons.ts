// SPDX-License-Identifier: GPL-3.0-or-later
import { svg } from './dom';

const PATHS: Record<string, string> = {
  play: 'M4 2.5l9 5.5-9 5.5z',
  pause: 'M4 3h3v10H4zM9 3h3v10H9z',
  first: 'M3 3h2v10H3zM13 3v10L6 8z',
  last: 'M11 3h2v10h-2zM3 3v10l7-5z',
  back: 'M10 3L5 8l5 5',
  on: 'M6 3l5 5-5 5',
  loop: 'M12.5 6A5 5 0 1 0 13 9M13 2.5V6H9.5',
};
const DRAWN = new Set(['back', 'on', 'loop']);

export const icon = (name: string): SVGElement =>
  svg('svg', { class: 'icon', width: 16, height: 16, viewBox: '0 0 16 16', 'aria-hidden': 'true' },
    svg('path', { d: PATHS[name], ...(DRAWN.has(name) ? { class: 'drawn' } : {}) }));
