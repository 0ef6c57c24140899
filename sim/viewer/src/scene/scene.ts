// SPDX-License-Identifier: GPL-3.0-or-later
// The three-dimensional view: draws what it is told, only when something has changed.
import * as THREE from 'three';
import { lookOf, nobodysLook } from '../model/palette';
import type { ViewModel } from '../model/view_model';
import type { Snapshot } from '../snapshot';
import { OrbitCamera } from './camera';
import { Drones } from './drones';
import { FatLines } from './fat_lines';
import { drawLabels } from './labels';
import { labelsOf, shownMarks } from './label_choice';
import { Picker } from './pick';
import { mixed, routeStrokes } from './routes';
import { SampleCloud } from './samples';
import { Structure, tonesOf } from './structure';

const PIECE_PX = 4.5, ROUTE_PX = 3.2;
const PIECE_BIAS = 2e-5, ROUTE_BIAS = 4e-5;

const MARK_REACH_PX = 12;

interface Content { structure: Structure; samples: SampleCloud | undefined; pieces: FatLines; routes: FatLines; drones: Drones; picker: Picker }

export class SceneView {
  readonly camera: OrbitCamera;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private content: Content | undefined;
  private model: ViewModel | undefined;
  private painted: string[] = [];
  private size = { width: 1, height: 1, pixel: 1 };

  constructor(private readonly canvas: HTMLCanvasElement, private readonly overlay: HTMLCanvasElement, moved: () => void) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.camera = new OrbitCamera(canvas, moved);
    const sun = new THREE.DirectionalLight('#ffffff', 1.6);
    sun.position.set(-0.4, -0.7, 1);
    this.scene.add(sun, new THREE.HemisphereLight('#ffffff', '#8a929a', 1.6));
  }

  get drawCalls(): number { return this.renderer.info.render.calls; }

  /** `keep`: the camera stays where it is. */
  show(model: ViewModel, dark: boolean, keep: boolean): void {
    this.clear();
    this.model = model;
    const structure = new Structure(model.data);
    const diagonal = structure.bounds.getSize(new THREE.Vector3()).length();
    const dash = diagonal / 24;
    const pieces = new FatLines(model.tasks.map(({ line, from_m }) => ({ line, along_m: from_m })), PIECE_PX, PIECE_BIAS, dash);
    const routes = new FatLines(routeStrokes(model), ROUTE_PX, ROUTE_BIAS, dash / 4);
    const drones = new Drones(model.agents.length);
    const { figures, samples: sampled } = model.data.coverage ?? {};
    const samples = figures && sampled ? new SampleCloud(sampled, figures) : undefined;
    this.content = { structure, samples, pieces, routes, drones, picker: new Picker(pieces) };
    this.scene.add(structure.group, pieces.mesh, routes.mesh, drones.group, ...(samples ? [samples.points] : []));
    this.camera.setOutline(structure.outline);
    this.setTheme(dark);
    this.resize();
    if (!keep) this.camera.fit();
  }

  private clear(): void {
    if (!this.content) return;
    const { structure, samples, pieces, routes, drones } = this.content;
    this.scene.remove(structure.group, pieces.mesh, routes.mesh, drones.group, ...(samples ? [samples.points] : []));
    for (const part of [structure, samples, pieces, routes, drones]) part?.dispose();
    this.content = undefined;
  }

  setTheme(dark: boolean): void {
    const tones = tonesOf(dark);
    this.scene.background = new THREE.Color(tones.background);
    this.content?.structure.setTheme(dark);
    for (const lines of [this.content?.pieces, this.content?.routes])
      lines?.setTheme(dark ? '#0b0e11' : '#4a5058', dark ? '#ffffff' : '#16191c');
    this.painted = [];
  }

  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const pixel = Math.min(window.devicePixelRatio || 1, 2);
    this.size = { width: Math.max(width, 1), height: Math.max(height, 1), pixel };
    this.renderer.setPixelRatio(pixel);
    this.renderer.setSize(this.size.width, this.size.height, false);
    this.overlay.width = Math.round(width * pixel);
    this.overlay.height = Math.round(height * pixel);
    this.camera.setAspect(this.size.width / this.size.height);
    this.content?.samples?.setScreen(this.camera.unit(this.size.height), pixel);
    for (const lines of [this.content?.pieces, this.content?.routes])
      lines?.setScreen(this.size.width * pixel, this.size.height * pixel, pixel);
  }

  render(now: Snapshot): void {
    if (!this.content || !this.model) return;
    const { structure, samples, routes, drones } = this.content;
    structure.veil(now.colouring !== 'plain');
    samples?.paint(now.colouring, now.only, now.dark, tonesOf(now.dark).background);
    this.paintPieces(now);
    this.paintRoutes(now);
    routes.setNow(now.flight_s);
    routes.mesh.visible = now.track === 'mission';
    drones.place(this.model.data.agents.map((agent) => ({
      position: this.model!.mission.placeOf(agent.agent, now.flight_s).position, home: agent.home,
      rgb: lookOf(this.model!.agentSlot(agent.agent), now.dark).rgb, alive: now.alive(agent.agent),
    })));
    drones.face(this.camera.camera, this.camera.unit(this.size.height));
    this.renderer.render(this.scene, this.camera.camera);
    const labels = labelsOf(this.model, now, (at) => this.project(at));
    drawLabels(this.overlay, labels, this.size.pixel, now.dark ? '#e8ebee' : '#14181c', now.dark ? '#161b21' : '#ffffff');
  }

  private paintPieces(now: Snapshot): void {
    const { pieces } = this.content!;
    const background = tonesOf(now.dark).background;
    const aside = now.track === 'mission' || now.colouring !== 'plain';
    for (let slot = 0; slot < now.owners.length; slot++) {
      const owner = now.owners[slot];
      const nobody = this.model!.agentSlot(owner) < 0;
      const chosen = slot === now.slot, pointed = slot === now.hover;
      const faint = now.agent !== null && now.agent !== owner && !chosen;
      const hatched = now.disputed[slot] === 1;
      const key = `${owner} ${hatched} ${chosen} ${pointed} ${faint} ${aside}`;
      if (this.painted[slot] === key) continue;
      this.painted[slot] = key;
      const look = nobody ? nobodysLook(now.dark) : lookOf(this.model!.agentSlot(owner), now.dark);
      // While drones fly, what they have flown stands out; colours of the structure do, while it has them.
      const fade = faint ? 0.78 : aside && !chosen ? 0.55 : 0;
      const usual = aside ? 0.5 : nobody ? 0.6 : 1;
      pieces.paint(slot, {
        rgb: mixed(look.rgb, background, fade), pattern: look.pattern, hatched, width: chosen ? 2.4 : pointed ? 1.7 : usual,
      });
    }
  }

  private paintRoutes(now: Snapshot): void {
    const { routes } = this.content!;
    const background = tonesOf(now.dark).background;
    routeStrokes(this.model!).forEach((stroke, i) => {
      const faint = now.agent !== null && now.agent !== stroke.agent;
      const key = faint ? 'faint' : 'plain';
      const slot = now.owners.length + i;
      if (this.painted[slot] === key) return;
      this.painted[slot] = key;
      const look = lookOf(this.model!.agentSlot(stroke.agent), now.dark);
      routes.paint(i, {
        rgb: mixed(look.rgb, background, faint ? 0.75 : stroke.transit ? 0.3 : 0), pattern: stroke.transit ? 2 : look.pattern,
        hatched: false, width: stroke.transit ? 0.5 : 1.4,
      });
    });
  }

  /** CSS pixels in the canvas; undefined behind the eye. */
  project(at: ArrayLike<number>): { x: number; y: number } | undefined {
    const camera = this.camera.camera;
    const point = new THREE.Vector3(at[0], at[1], at[2]).applyMatrix4(camera.matrixWorldInverse);
    if (point.z > -camera.near) return undefined;
    point.applyMatrix4(camera.projectionMatrix);
    return { x: (point.x + 1) * 0.5 * this.size.width, y: (1 - point.y) * 0.5 * this.size.height };
  }

  /** The piece at a point of the canvas, by its place in the list of tasks; -1: none. */
  pieceAt(x: number, y: number): number {
    return this.content?.picker.at(this.camera.camera, x, y, this.size.width, this.size.height) ?? -1;
  }

  /** The agent whose nearest place to the structure is at a point of the canvas. */
  markAt(x: number, y: number, now: Snapshot): number | undefined {
    if (!this.model) return undefined;
    const gap = (at: { x: number; y: number }): number => Math.hypot(at.x - x, at.y - y);
    const marks = shownMarks(this.model, now, (at) => this.project(at)).filter(({ at }) => gap(at) <= MARK_REACH_PX);
    return marks.sort((a, b) => gap(a.at) - gap(b.at))[0]?.agent;
  }
}
