// The picture's element: canvas, camera, what the page shows in it, and when it is drawn anew.
import type { Scene, Vector } from '../documents';
import { usable } from './bounds';
import { readTheme } from './colours';
import { Controls } from './controls';
import type { Controlled } from './controls';
import { clampCamera, frame, metresPerPixel, parallelRay, rayThrough, viewOf } from './orbit';
import type { View } from './orbit';
import { drawOver, strip } from './over';
import { pick } from './picking';
import type { Ray } from './picking';
import { Picture } from './picture';
import type { Stage } from './stage';
import { makeStage } from './make_stage';
import type {
  Arrow,
  Bounds,
  CameraState,
  ContactMark,
  Grab,
  Layer,
  Pose,
  Pull,
  Scene3D,
  Scene3DOptions,
} from './types';
import { add, conjugate, dot, length, rotate, scale, subtract } from './vectors';

export class LiveScene3D implements Scene3D, Controlled {
  readonly element: HTMLCanvasElement;
  readonly webgl: boolean;
  onCamera: ((state: CameraState) => void) | null = null;
  onFrameAll: (() => void) | null = null;
  onGrab: ((grab: Grab) => void) | null = null;
  onPull: ((point: Vector) => void) | null = null;
  onRelease: (() => void) | null = null;
  private readonly root = document.createElement('div');
  private readonly over = document.createElement('canvas');
  private readonly note = document.createElement('div');
  private readonly stage: Stage;
  private readonly controls: Controls;
  private picture: Picture;
  private state: CameraState;
  private framed = false; // somebody chose the camera
  private framing: Bounds | null = null; // what the camera holds until then, if not the picture's bounds
  private stale = true;
  private overStale = true; // axes and scale bar
  private held: Vector | null = null; // where a body was grabbed [m]
  private readonly stop = new AbortController();
  private readonly resized = new ResizeObserver(() => this.turned());
  private readonly restyled = new MutationObserver(() => this.retheme());

  constructor(
    host: HTMLElement,
    scene: Scene,
    private readonly options: Scene3DOptions,
  ) {
    this.root.className = 'scene3d';
    host.append(this.root);
    this.stage = makeStage();
    this.stage.onChange = () => this.relabel();
    this.webgl = this.stage.webgl;
    this.element = this.stage.canvas;
    this.element.tabIndex = 0;
    this.element.setAttribute('role', 'application');
    this.element.setAttribute('aria-roledescription', '3D view');
    this.element.setAttribute(
      'aria-label',
      `${options.label}. Arrow keys turn, plus and minus zoom, Home frames all.`,
    );
    this.over.className = 'scene3d-over';
    this.over.setAttribute('aria-hidden', 'true');
    this.note.className = 'scene3d-note';
    this.note.setAttribute('role', 'status');
    this.root.append(this.element, this.over, this.note);
    this.picture = new Picture(scene, readTheme(this.root), options.bounds);
    this.stage.show(this.picture);
    this.state = frame(this.picture.bounds, 4 / 3);
    this.controls = new Controls(this.element, this);
    this.resized.observe(this.root);
    this.restyled.observe(document.documentElement, {
      attributes: true,
      attributeFilter: ['class', 'style', 'data-theme'],
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.retheme(), {
      signal: this.stop.signal,
    });
  }

  get camera(): CameraState {
    return this.state;
  }

  set camera(state: CameraState) {
    this.state = clampCamera(state);
    this.framed = true;
    this.turned();
  }

  moveCamera(state: CameraState): void {
    this.camera = state;
    this.onCamera?.(this.state);
  }

  frameOn(bounds: Bounds): void {
    this.framing = usable(bounds);
    this.turned();
  }

  frameAll(): void {
    this.framed = false;
    this.turned();
  }

  /** The user asks for the whole scene. */
  reset(): void {
    this.frameAll();
    this.view();
    if (this.onFrameAll) this.onFrameAll();
    else this.onCamera?.(this.state);
  }

  show(layer: Layer, pose: Pose | null, time: number): void {
    this.picture.layers[layer].set(pose);
    if (Number.isFinite(time)) this.picture.time = time;
    this.stale = true;
    if (layer === 'bodies') this.relabel();
  }

  private relabel(): void {
    const lost = this.picture.lost();
    const names =
      lost.length > 3 ? `${lost.slice(0, 3).join(', ')} and ${lost.length - 3} more` : lost.join(', ');
    const text = this.stage.lost
      ? 'the graphics card was lost; waiting for it'
      : lost.length > 0
        ? `not finite: ${names}`
        : '';
    if (this.note.textContent !== text) this.note.textContent = text;
    this.stale = true;
  }

  trails(layer: Layer, positions: Float32Array | null, bodies: number, upTo: number): void {
    this.picture.setTrail(layer, positions, bodies, upTo);
    this.stale = true;
  }

  arrows(list: Arrow[]): void {
    this.picture.arrows = list;
    this.stale = true;
  }

  contacts(list: ContactMark[], largest?: number): void {
    this.picture.setContacts(list, largest);
    this.stale = true;
  }

  pulls(list: Pull[]): void {
    this.picture.pulls = list;
    this.stale = true;
  }

  links(shown: boolean): void {
    this.picture.linksShown = shown;
    this.stale = true;
  }

  replaceScene(scene: Scene): void {
    const { linksShown } = this.picture;
    this.picture = new Picture(scene, this.picture.theme, this.options.bounds);
    this.picture.linksShown = linksShown;
    this.stage.show(this.picture);
    this.relabel();
    this.turned();
  }

  private retheme(): void {
    this.picture.theme = readTheme(this.root);
    this.turned();
  }

  private view(): View {
    const width = Math.max(this.root.clientWidth, 1);
    const height = Math.max(this.root.clientHeight, 1);
    const held = this.framing ?? this.picture.bounds;
    if (!this.framed) this.state = frame(held, width / height);
    const extent = length(subtract(held.max, held.min));
    return viewOf(this.state, { width, height, ratio: Math.min(devicePixelRatio || 1, 2) }, extent);
  }

  metresPerPixel(): number {
    return metresPerPixel(this.view());
  }

  private ray(view: View, x: number, y: number): Ray {
    return this.webgl ? rayThrough(view, x, y) : parallelRay(view, x, y);
  }

  grab(x: number, y: number): boolean {
    const bodies = this.picture.layers.bodies;
    if (!this.onGrab || !bodies.shown) return false;
    const view = this.view();
    const pixel = metresPerPixel(view);
    const least = (depth: number): number => 6 * pixel * (this.webgl ? depth / view.distance : 1);
    const found = pick(this.ray(view, x, y), this.picture.solids, bodies, least);
    if (!found || this.picture.scene.body[found.body]!.locked) return false;
    const { body, point } = found;
    this.held = point;
    this.onGrab({
      body,
      point,
      anchor: rotate(conjugate(bodies.turn(body)), subtract(point, bodies.at(body))),
    });
    return true;
  }

  /** The point of the ray in the plane through the grab that faces the camera. */
  pull(x: number, y: number): void {
    if (!this.held) return;
    const view = this.view();
    const { from, along } = this.ray(view, x, y);
    const s = dot(subtract(this.held, from), view.back) / dot(along, view.back);
    this.onPull?.(add(from, scale(along, s)));
  }

  release(): void {
    this.held = null;
    this.onRelease?.();
  }

  render(): void {
    if (!this.stale) return;
    this.stale = false;
    this.picture.relink();
    const view = this.view();
    const { grid } = this.picture;
    this.picture.setEye(view.eye, this.framing ?? this.picture.bounds);
    if (this.picture.grid !== grid) this.overStale = true;
    this.stage.draw(view);
    if (this.overStale) this.drawOver(view);
  }

  private drawOver(view: View): void {
    this.overStale = false;
    [this.over.width, this.over.height] = [this.element.width, Math.round(strip * view.ratio)];
    const grid = this.picture.scene.plane.length > 0 ? this.picture.grid : null;
    const context = this.over.getContext('2d');
    if (context) drawOver(context, view, this.picture.theme, grid);
  }

  /** The camera, the size or the colours changed: all is drawn anew. */
  private turned(): void {
    this.stale = this.overStale = true;
  }

  get size(): { width: number; height: number } {
    return { width: this.element.width, height: this.element.height };
  }

  /** Both canvases; drawn in the same task, since a browser may clear a WebGL canvas after it. */
  paint(context: CanvasRenderingContext2D, x: number, y: number): void {
    this.stale = true;
    this.render();
    context.drawImage(this.element, x, y);
    context.drawImage(this.over, x, y + this.element.height - this.over.height);
  }

  png(): Promise<Blob> {
    const both = document.createElement('canvas');
    this.stale = true;
    this.render();
    [both.width, both.height] = [this.element.width, this.element.height];
    const context = both.getContext('2d');
    if (context) this.paint(context, 0, 0);
    return new Promise((resolve, reject) =>
      both.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be kept'))),
        'image/png',
      ),
    );
  }

  dispose(): void {
    this.stop.abort();
    this.resized.disconnect();
    this.restyled.disconnect();
    this.controls.dispose();
    this.stage.dispose();
    this.root.remove();
    this.onCamera = this.onFrameAll = this.onGrab = this.onPull = this.onRelease = null;
  }
}
