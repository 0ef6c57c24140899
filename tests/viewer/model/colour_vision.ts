// SPDX-License-Identifier: GPL-3.0-or-later
// Colours as they look without one kind of cones (Machado, Oliveira and Fernandes 2009, severity 1), and how
// far apart two look (CIE 1976).

type Triple = [number, number, number];
type Matrix = [Triple, Triple, Triple];

/** On linear RGB. */
export const VISIONS: Record<string, Matrix> = {
  trichromat: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanope: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranope: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanope: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const TO_XYZ: Matrix = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.072175], [0.0193339, 0.119192, 0.9503041]];
const WHITE: Triple = [0.95047, 1, 1.08883];

const times = (matrix: Matrix, v: Triple): Triple => matrix.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) as Triple;
const linear = (value: number): number => (value <= 10.31475 ? value / 3294.6 : ((value / 255 + 0.055) / 1.055) ** 2.4);

/** Linear RGB. */
export const seenBy = (vision: string, rgb: Triple): Triple =>
  times(VISIONS[vision], rgb.map(linear) as Triple).map((value) => Math.min(Math.max(value, 0), 1)) as Triple;

export function labOf(rgb: Triple): Triple {
  const [x, y, z] = times(TO_XYZ, rgb).map((value, i) => {
    const t = value / WHITE[i];
    return t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116;
  });
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

export const distance = (a: Triple, b: Triple): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
