// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that stands on the ground's up, orbits by mouse and by key, and fits a box into the view.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** The way the box is longer goes across the picture; seen from a little aside and above. */
const ASIDE = -0.45, ABOVE = 0.42;

export class OrbitCamera {
  readonly camera = new THREE.PerspectiveCamera(38, 1, 0.1, 10000);
  private readonly controls: OrbitControls;
  private outline: THREE.Vector3[] = [];
  private bounds = new THREE.Box3();

  constructor(canvas: HTMLElement, moved: () => void) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', moved);
  }

  setOutline(outline: THREE.Vector3[]): void {
    this.outline = outline;
    this.bounds.setFromPoints(outline);
    const size = this.bounds.getSize(new THREE.Vector3()).length();
    this.camera.near = size / 2000;
    this.camera.far = size * 20;
    this.controls.minDistance = size / 200;
    this.controls.maxDistance = size * 8;
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  fit(): void {
    const size = this.bounds.getSize(new THREE.Vector3());
    const across = size.x >= size.y ? 0 : Math.PI / 2;
    const azimuth = across - Math.PI / 2 + ASIDE;
    const away = new THREE.Vector3(Math.cos(azimuth) * Math.cos(ABOVE), Math.sin(azimuth) * Math.cos(ABOVE), Math.sin(ABOVE));
    const centre = this.bounds.getCenter(new THREE.Vector3());
    // Each fit shows how far off the middle the picture is; what is moved then needs a new fit.
    for (let i = 0; i < 4; i++) {
      this.standBack(centre, away, size.length());
      this.moveToMiddle(centre);
    }
    this.standBack(centre, away, size.length());
    this.controls.update();
  }

  /** As near as all can be seen. */
  private standBack(centre: THREE.Vector3, away: THREE.Vector3, size: number): void {
    let near = size / 100, far = size * 8;
    for (let i = 0; i < 24; i++) {
      const middle = (near + far) / 2;
      this.stand(centre, away, middle);
      const { min, max } = this.extent();
      const holds = max.z <= 1 && Math.max(-min.x, max.x) <= 0.92 && Math.max(-min.y, max.y) <= 0.84;
      if (holds) far = middle; else near = middle;
    }
    this.stand(centre, away, far);
  }

  private stand(centre: THREE.Vector3, away: THREE.Vector3, distance: number): void {
    this.camera.position.copy(centre).addScaledVector(away, distance);
    this.controls.target.copy(centre);
    this.camera.lookAt(centre);
    this.camera.updateMatrixWorld();
  }

  /** Of the outline in the picture, which reaches from -1 to 1. */
  private extent(): THREE.Box3 {
    const box = new THREE.Box3(), at = new THREE.Vector3();
    for (const place of this.outline) {
      at.copy(place).applyMatrix4(this.camera.matrixWorldInverse);
      const behind = at.z > -this.camera.near;
      at.applyMatrix4(this.camera.projectionMatrix);
      if (behind) at.z = Infinity;
      box.expandByPoint(at);
    }
    return box;
  }

  private moveToMiddle(centre: THREE.Vector3): void {
    const off = this.extent().getCenter(new THREE.Vector3());
    const depth = centre.clone().project(this.camera).z;
    centre.copy(new THREE.Vector3(off.x, off.y, depth).unproject(this.camera));
  }

  /** Looks at a place from where one looks now, from nearer by. */
  goTo(at: number[], distance: number): void {
    const away = this.camera.position.clone().sub(this.controls.target).normalize();
    const { minDistance, maxDistance } = this.controls;
    this.stand(new THREE.Vector3().fromArray(at), away, Math.min(Math.max(distance, 2 * minDistance), maxDistance));
    this.controls.update();
  }

  get target(): number[] { return this.controls.target.toArray(); }

  /** By key: angles in radians, nearer by a factor. */
  turn(aside: number, up: number, closer = 1): void {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const spherical = new THREE.Spherical().setFromVector3(new THREE.Vector3(arm.y, arm.z, arm.x));
    spherical.theta += aside;
    spherical.phi = Math.min(Math.max(spherical.phi - up, 0.05), Math.PI - 0.05);
    spherical.radius *= closer;
    const turned = new THREE.Vector3().setFromSpherical(spherical);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3(turned.z, turned.x, turned.y));
    this.controls.update();
  }

  /** Metres a pixel, one metre away. */
  unit(height: number): number {
    return (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / Math.max(height, 1);
  }
}
