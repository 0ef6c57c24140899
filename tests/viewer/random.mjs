// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in [0, 1) that depend on the seed alone (xorshift32).
export function seeded(seed) {
  let state = seed >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 4294967296;
  };
}
