// SPDX-License-Identifier: GPL-3.0-or-later

/** How many of `length` ascending values are at most `limit`. */
export function countUpTo(length: number, value: (i: number) => number, limit: number): number {
  let low = 0, high = length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (value(middle) <= limit) low = middle + 1; else high = middle;
  }
  return low;
}

/** The nearest of ascending times beyond `t` in a direction. */
export function neighbour(times: ArrayLike<number>, t: number, direction: 1 | -1): number | undefined {
  let i = countUpTo(times.length, (k) => times[k], t);
  if (direction < 0) for (i--; i >= 0 && times[i] >= t; ) i--;
  return i >= 0 && i < times.length ? times[i] : undefined;
}
