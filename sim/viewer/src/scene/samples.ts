// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of the structure in the colours of a legend: one draw call. What a colour means is told to the GPU as
// a short list, so that another meaning costs no more than that.
import * as THREE from 'three';
import { legendOf, placesOf, type Colouring } from '../model/colouring';
import type { Figures, Samples } from '../model/coverage';
import { sampleFragment, sampleVertex } from './shaders';
import { mixed } from './routes';

const MOST_COLOURS = 8;
/** Of the distance between samples: far enough from the surface that its two sides do not meet (4.5 cm of 30). */
const SHIFT = 0.15;
/** Overlap, so that neighbours leave no gaps. */
const WIDTH = 1.25;
const FAINT = 0.82;

export class SampleCloud {
  readonly points: THREE.Points;
  private readonly uniforms;
  private painted = '';

  constructor(private readonly samples: Samples, figures: Figures) {
    const count = samples.class.length;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(samples.positions, 3));
    geometry.setAttribute('aNormal', new THREE.BufferAttribute(wordsOf(samples.normals), 4, true));
    geometry.setAttribute('aPlaces', new THREE.BufferAttribute(placesOf(samples), 4));
    const spread = figures.spacing_m * Math.sqrt(Math.max(samples.total, count) / count);
    this.uniforms = {
      uColours: { value: Array.from({ length: MOST_COLOURS }, () => new THREE.Vector3()) }, uByBin: { value: 0 },
      uShift: { value: SHIFT * figures.spacing_m }, uSize: { value: WIDTH * spread }, uPerMetre: { value: 1 }, uPixel: { value: 1 },
    };
    const material = new THREE.ShaderMaterial({ vertexShader: sampleVertex, fragmentShader: sampleFragment, uniforms: this.uniforms });
    this.points = new THREE.Points(geometry, material);
    this.points.frustumCulled = false;
    this.points.visible = false;
  }

  /** `only`: the place in the legend of what is to stand out. */
  paint(colouring: Colouring, only: number | null, dark: boolean, background: string): void {
    const key = `${colouring} ${only} ${dark}`;
    if (key === this.painted) return;
    this.painted = key;
    this.points.visible = colouring !== 'plain';
    this.uniforms.uByBin.value = colouring === 'redundancy' ? 1 : 0;
    legendOf(this.samples, colouring, dark).forEach(({ rgb }, i) => {
      const [r, g, b] = mixed(rgb, background, only !== null && only !== i ? FAINT : 0);
      this.uniforms.uColours.value[i].set(r / 255, g / 255, b / 255);
    });
  }

  /** `unit`: metres a pixel of CSS at one metre's distance; `pixel`: pixels of the screen in one of CSS. */
  setScreen(unit: number, pixel: number): void {
    this.uniforms.uPerMetre.value = pixel / unit;
    this.uniforms.uPixel.value = pixel;
  }

  dispose(): void {
    this.points.geometry.dispose();
    (this.points.material as THREE.Material).dispose();
  }
}

/** GPUs read whole words. */
function wordsOf(triples: Int8Array): Int8Array {
  const words = new Int8Array((triples.length / 3) * 4);
  for (let i = 0; 3 * i < triples.length; i++) words.set(triples.subarray(3 * i, 3 * i + 3), 4 * i);
  return words;
}
