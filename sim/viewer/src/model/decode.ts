// SPDX-License-Identifier: GPL-3.0-or-later
// From what is embedded or served to view data.

export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const binary = atob(base64);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

const isGzip = (bytes: Uint8Array): boolean => bytes[0] === 0x1f && bytes[1] === 0x8b;

/** JSON, packed or not: whoever fetched it may have unpacked it by the way. */
export async function jsonOf(bytes: Uint8Array<ArrayBuffer>): Promise<unknown> {
  if (!isGzip(bytes)) return JSON.parse(new TextDecoder().decode(bytes));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return JSON.parse(await new Response(unpacked).text());
}

/** Values that are not whole at the end are left out. The format is little-endian, as is every browser. */
export function floatsOf(base64: string | undefined): Float32Array {
  const bytes = bytesOf(base64 ?? '');
  return new Float32Array(bytes.buffer, 0, Math.floor(bytes.length / 12) * 3);
}

/** Triangles of `vertices` vertices; those that name one beyond are left out. */
export function trianglesOf(base64: string | undefined, vertices: number): Uint32Array {
  const bytes = bytesOf(base64 ?? '');
  const all = new Uint32Array(bytes.buffer, 0, Math.floor(bytes.length / 12) * 3);
  const legal: number[] = [];
  for (let i = 0; i < all.length; i += 3)
    if (all[i] < vertices && all[i + 1] < vertices && all[i + 2] < vertices)
      legal.push(all[i], all[i + 1], all[i + 2]);
  return legal.length === all.length ? all : new Uint32Array(legal);
}
