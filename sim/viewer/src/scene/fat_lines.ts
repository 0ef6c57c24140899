// SPDX-License-Identifier: GPL-3.0-or-later
// Many polylines in one draw call, each with a colour, dashes and a width that may change.
import * as THREE from 'three';
import { lineFragment, lineVertex } from './shaders';

export interface Stroke { line: number[]; at_s?: number[]; along_m?: number }
export interface StrokeLook { rgb: [number, number, number]; pattern: number; hatched: boolean; width: number }

const corners = [0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0];

export class FatLines {
  readonly mesh: THREE.Mesh;
  /** First segment of each stroke; one more at the end. */
  readonly firsts: Uint32Array;
  readonly starts: Float32Array;
  readonly ends: Float32Array;
  private readonly colours: THREE.InstancedBufferAttribute;
  private readonly styles: THREE.InstancedBufferAttribute;
  private readonly uniforms;

  constructor(strokes: Stroke[], width: number, bias: number, dash: number) {
    this.firsts = new Uint32Array(strokes.length + 1);
    strokes.forEach(({ line }, i) => (this.firsts[i + 1] = this.firsts[i] + Math.max(Math.floor(line.length / 3) - 1, 0)));
    const count = this.firsts[strokes.length];
    this.starts = new Float32Array(3 * count);
    this.ends = new Float32Array(3 * count);
    const along = new Float32Array(2 * count), time = new Float32Array(2 * count);
    strokes.forEach((stroke, i) => this.lay(stroke, this.firsts[i], along, time));
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const instanced = (name: string, values: Float32Array, size: number): THREE.InstancedBufferAttribute => {
      const attribute = new THREE.InstancedBufferAttribute(values, size);
      geometry.setAttribute(name, attribute);
      return attribute;
    };
    instanced('aStart', this.starts, 3);
    instanced('aEnd', this.ends, 3);
    instanced('aAlong', along, 2);
    instanced('aTime', time, 2);
    this.colours = instanced('aColour', new Float32Array(3 * count), 3);
    this.styles = instanced('aStyle', new Float32Array(3 * count), 3);
    geometry.instanceCount = count;
    this.uniforms = {
      uScreen: { value: new THREE.Vector2(1, 1) }, uWidth: { value: width }, uPixel: { value: 1 }, uBias: { value: bias },
      uDash: { value: dash }, uNow: { value: 0 }, uCasing: { value: new THREE.Color() }, uHatch: { value: new THREE.Color() },
    };
    const material = new THREE.ShaderMaterial({
      vertexShader: lineVertex, fragmentShader: lineFragment, uniforms: this.uniforms, side: THREE.DoubleSide,
    });
    this.width = width;
    this.mesh = new THREE.Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  private readonly width: number;

  private lay({ line, at_s, along_m = 0 }: Stroke, first: number, along: Float32Array, time: Float32Array): void {
    let at = along_m;
    for (let k = 0; 3 * k + 5 < line.length; k++) {
      const s = first + k;
      for (let axis = 0; axis < 3; axis++) {
        this.starts[3 * s + axis] = line[3 * k + axis];
        this.ends[3 * s + axis] = line[3 * k + 3 + axis];
      }
      along[2 * s] = at;
      at += Math.hypot(line[3 * k + 3] - line[3 * k], line[3 * k + 4] - line[3 * k + 1], line[3 * k + 5] - line[3 * k + 2]);
      along[2 * s + 1] = at;
      time[2 * s] = at_s?.[k] ?? 0;
      time[2 * s + 1] = at_s?.[k + 1] ?? 0;
    }
  }

  paint(stroke: number, look: StrokeLook): void {
    const [r, g, b] = look.rgb;
    for (let s = this.firsts[stroke]; s < this.firsts[stroke + 1]; s++) {
      this.colours.setXYZ(s, r / 255, g / 255, b / 255);
      this.styles.setXYZ(s, look.pattern, look.hatched ? 1 : 0, look.width);
    }
    const from = 3 * this.firsts[stroke], count = 3 * (this.firsts[stroke + 1] - this.firsts[stroke]);
    for (const attribute of [this.colours, this.styles]) {
      attribute.addUpdateRange(from, count);
      attribute.needsUpdate = true;
    }
  }

  setScreen(width: number, height: number, pixel: number): void {
    this.uniforms.uScreen.value.set(width, height);
    this.uniforms.uPixel.value = pixel;
    this.uniforms.uWidth.value = this.width * pixel;
  }

  setTheme(casing: string, hatch: string): void {
    this.uniforms.uCasing.value.setStyle(casing, THREE.LinearSRGBColorSpace);
    this.uniforms.uHatch.value.setStyle(hatch, THREE.LinearSRGBColorSpace);
  }

  setNow(t: number): void { this.uniforms.uNow.value = t; }

  dispose(): void {
    this.mesh.geometry.dispose();
    (this.mesh.material as THREE.Material).dispose();
  }
}
