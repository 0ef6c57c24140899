// SPDX-License-Identifier: GPL-3.0-or-later
// The fleet: one instanced drone and one instanced home pad for each agent, of a size on the screen.
import * as THREE from 'three';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';

function quadcopter(): THREE.BufferGeometry {
  const parts: THREE.BufferGeometry[] = [new THREE.SphereGeometry(0.42, 12, 8).scale(1, 1, 0.7)];
  for (const angle of [Math.PI / 4, -Math.PI / 4]) parts.push(new THREE.BoxGeometry(2, 0.22, 0.2).rotateZ(angle));
  for (const x of [-0.72, 0.72]) for (const y of [-0.72, 0.72])
    parts.push(new THREE.CylinderGeometry(0.46, 0.46, 0.14, 16).rotateX(Math.PI / 2).translate(x, y, 0.18));
  return mergeGeometries(parts)!;
}

export interface Drone { position: number[]; home: number[]; rgb: number[]; alive: boolean }

const GONE = new THREE.Color('#7b828a');

export class Drones {
  readonly group = new THREE.Group();
  private readonly bodies: THREE.InstancedMesh;
  private readonly pads: THREE.InstancedMesh;
  private drones: Drone[] = [];

  constructor(count: number) {
    // In front of the line it flies along.
    const body = new THREE.MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4000 });
    this.bodies = new THREE.InstancedMesh(quadcopter(), body, count);
    this.pads = new THREE.InstancedMesh(new THREE.RingGeometry(0.9, 1.25, 32), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }), count);
    for (const mesh of [this.bodies, this.pads]) {
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
  }

  place(drones: Drone[]): void {
    this.drones = drones;
    const colour = new THREE.Color();
    drones.forEach(({ rgb, alive }, i) => {
      colour.setRGB(rgb[0] / 255, rgb[1] / 255, rgb[2] / 255, THREE.SRGBColorSpace);
      this.pads.setColorAt(i, colour);
      this.bodies.setColorAt(i, alive ? colour : GONE);
    });
    for (const mesh of [this.bodies, this.pads]) if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
  }

  /** `unit`: metres a pixel at one metre's distance. */
  face(camera: THREE.Camera, unit: number): void {
    const matrix = new THREE.Matrix4(), at = new THREE.Vector3(), scale = new THREE.Vector3(), level = new THREE.Quaternion();
    const put = (mesh: THREE.InstancedMesh, i: number, [x, y, z]: number[], pixels: number): void => {
      at.set(x, y, z);
      const size = Math.max(camera.position.distanceTo(at) * unit * pixels, 0.25);
      mesh.setMatrixAt(i, matrix.compose(at, level, scale.setScalar(size)));
    };
    this.drones.forEach(({ position, home, alive }, i) => {
      put(this.bodies, i, position, alive ? 14 : 8);
      put(this.pads, i, home, 8);
    });
    this.bodies.instanceMatrix.needsUpdate = this.pads.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    for (const mesh of [this.bodies, this.pads]) {
      mesh.geometry.dispose();
      (mesh.material as THREE.Material).dispose();
      mesh.dispose();
    }
  }
}
