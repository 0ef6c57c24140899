// SPDX-License-Identifier: GPL-3.0-or-later
// What is inspected: a cloud of points or a mesh, on a faint grid.
import * as THREE from 'three';
import { floatsOf, trianglesOf } from '../model/decode';
import type { RunData } from '../model/data';

export interface Tones { background: string; low: string; high: string; grid: string }

export const tonesOf = (dark: boolean): Tones => dark
  ? { background: '#11151a', low: '#2c343d', high: '#77838f', grid: '#1d242b' }
  : { background: '#f3f4f5', low: '#8f979f', high: '#c3c9cf', grid: '#e3e6e8' };

/** As many of the structure's points as the view needs to be fitted to. */
const OUTLINE = 2000;

/** Places that the view is to hold: of the structure, the arcs and the homes. */
function outlineOf(data: RunData, points: Float32Array): THREE.Vector3[] {
  const stride = 3 * Math.max(1, Math.floor(points.length / 3 / OUTLINE));
  const outline: THREE.Vector3[] = [];
  for (let i = 0; i + 2 < points.length; i += stride) outline.push(new THREE.Vector3().fromArray(points, i));
  for (const { line } of [...data.arcs, ...data.tasks])
    for (let i = 0; i + 2 < line.length; i += 3) outline.push(new THREE.Vector3().fromArray(line, i));
  for (const { home } of data.agents) outline.push(new THREE.Vector3().fromArray(home));
  return outline.length > 0 ? outline : [new THREE.Vector3(-10, -10, 0), new THREE.Vector3(10, 10, 10)];
}

export class Structure {
  readonly group = new THREE.Group();
  readonly points: Float32Array;
  readonly outline: THREE.Vector3[];
  readonly bounds: THREE.Box3;
  private solid: THREE.Points | THREE.Mesh | undefined;
  private grid: THREE.LineSegments | undefined;
  private veiled = false;

  constructor(private readonly data: RunData) {
    this.points = floatsOf(data.structure.points);
    this.outline = outlineOf(data, this.points);
    this.bounds = new THREE.Box3().setFromPoints(this.outline);
  }

  setTheme(dark: boolean): void {
    this.dispose();
    const tones = tonesOf(dark);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.points, 3));
    const triangles = trianglesOf(this.data.structure.triangles, this.points.length / 3);
    if (triangles.length > 0) {
      geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
      const material = new THREE.MeshLambertMaterial({ color: tones.high, flatShading: true, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 });
      this.solid = new THREE.Mesh(geometry, material);
    } else if (this.points.length > 0) {
      geometry.setAttribute('color', new THREE.BufferAttribute(this.shades(tones), 3));
      const material = new THREE.PointsMaterial({ size: this.grain(), vertexColors: true });
      this.solid = new THREE.Points(geometry, material);
    }
    if (this.solid) this.group.add(this.solid);
    this.veil(this.veiled);
    this.grid = this.makeGrid(tones);
    this.group.add(this.grid);
  }

  /** Samples stand for a cloud; a mesh stays, for it hides those behind it. */
  veil(veiled: boolean): void {
    this.veiled = veiled;
    if (this.solid instanceof THREE.Points) this.solid.visible = !veiled;
  }

  /** Higher is lighter: the one cue of form that a bare cloud has. */
  private shades(tones: Tones): Float32Array {
    const low = new THREE.Color(tones.low), high = new THREE.Color(tones.high);
    const { min, max } = this.bounds;
    const colours = new Float32Array(this.points.length);
    const mixed = new THREE.Color();
    for (let i = 0; i < this.points.length; i += 3)
      mixed.lerpColors(low, high, (this.points[i + 2] - min.z) / Math.max(max.z - min.z, 1e-6)).toArray(colours, i);
    return colours;
  }

  /** About as large as points lie apart. */
  private grain(): number {
    const size = this.bounds.getSize(new THREE.Vector3());
    return 0.5 * Math.sqrt((size.x * Math.max(size.y, size.z) * 2) / Math.max(this.points.length / 3, 1));
  }

  private makeGrid(tones: Tones): THREE.LineSegments {
    const { min, max } = this.bounds;
    const centre = this.bounds.getCenter(new THREE.Vector3());
    const span = 1.6 * Math.max(max.x - min.x, max.y - min.y);
    const step = 10 ** Math.round(Math.log10(span / 20));
    const lines = Math.ceil(span / step);
    const grid = new THREE.GridHelper(lines * step, lines, tones.grid, tones.grid);
    grid.rotation.x = Math.PI / 2;
    grid.position.set(centre.x, centre.y, min.z - 0.002 * span);
    return grid;
  }

  dispose(): void {
    for (const object of [this.solid, this.grid])
      if (object) {
        this.group.remove(object);
        object.geometry.dispose();
        (object.material as THREE.Material).dispose();
      }
    this.solid = this.grid = undefined;
  }
}
