// SPDX-License-Identifier: GPL-3.0-or-later
// What is missing, or of another type than it must be, is empty.

export type Json = Record<string, unknown>;
export const object = (value: unknown): Json =>
  value !== null && typeof value === 'object' && !Array.isArray(value) ? (value as Json) : {};
export const list = <T>(value: unknown): T[] => (Array.isArray(value) ? (value as T[]) : []);
export const number = (value: unknown, otherwise: number): number =>
  typeof value === 'number' && Number.isFinite(value) ? value : otherwise;
export const text = (value: unknown): string => (typeof value === 'string' ? value : '');
