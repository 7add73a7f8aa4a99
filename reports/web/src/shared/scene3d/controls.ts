// Mouse, wheel, fingers and keys move the camera, or grab a body where the page wants that.
import { axes } from './orbit';
import type { CameraState } from './types';
import { add, scale } from './vectors';

/** What the controls need of their picture. */
export interface Controlled {
  readonly camera: CameraState;
  moveCamera(state: CameraState): void;
  metresPerPixel(): number; // at the target
  reset(): void;
  grab(x: number, y: number): boolean; // [css px]; true: a body was there and is held now
  pull(x: number, y: number): void;
  release(): void;
}

const perPixel = 0.008; // [rad]
const perKey = Math.PI / 36; // [rad]

export function turned(camera: CameraState, across: number, up: number): CameraState {
  return { ...camera, azimuth: camera.azimuth - across, elevation: camera.elevation + up };
}

/** Moves the target in the plane of the picture [m]. */
export function shifted(camera: CameraState, right: number, up: number): CameraState {
  const [r, u] = axes(camera);
  return { ...camera, target: add(camera.target, add(scale(r, right), scale(u, up))) };
}

export const nearer = (camera: CameraState, factor: number): CameraState => ({
  ...camera,
  distance: camera.distance * factor,
});

export class Controls {
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private holds = false;
  private readonly stop = new AbortController();

  constructor(
    private readonly element: HTMLElement,
    private readonly scene: Controlled,
  ) {
    const on = { signal: this.stop.signal };
    element.addEventListener('pointerdown', this.down, on);
    element.addEventListener('pointermove', this.move, on);
    element.addEventListener('pointerup', this.up, on);
    element.addEventListener('pointercancel', this.up, on);
    element.addEventListener('wheel', this.wheel, { ...on, passive: false });
    element.addEventListener('keydown', this.key, on);
    element.addEventListener('contextmenu', (event) => event.preventDefault(), on);
  }

  private readonly down = (event: PointerEvent): void => {
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (this.pointers.size > 1) this.letGo();
    else if (event.button === 0 && !event.shiftKey)
      this.holds = this.scene.grab(event.offsetX, event.offsetY);
  };

  private readonly move = (event: PointerEvent): void => {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const [x, y] = [event.offsetX, event.offsetY];
    const [dx, dy] = [x - last.x, y - last.y];
    if (this.holds) this.scene.pull(x, y);
    else if (this.pointers.size === 1) {
      const camera = this.scene.camera;
      const k = this.scene.metresPerPixel();
      const aside = event.shiftKey || (event.buttons & 6) !== 0; // right or middle button
      this.scene.moveCamera(
        aside ? shifted(camera, -dx * k, dy * k) : turned(camera, dx * perPixel, dy * perPixel),
      );
    } else if (this.pointers.size === 2) this.pinch(event.pointerId, last, { x, y });
    this.pointers.set(event.pointerId, { x, y });
  };

  /** Two fingers: their distance zooms, their middle moves the target. */
  private pinch(id: number, last: { x: number; y: number }, now: { x: number; y: number }): void {
    for (const [other, p] of this.pointers) {
      if (other === id) continue;
      const before = Math.hypot(last.x - p.x, last.y - p.y);
      const after = Math.hypot(now.x - p.x, now.y - p.y);
      const k = this.scene.metresPerPixel() / 2;
      const zoomed = before > 4 && after > 4 ? nearer(this.scene.camera, before / after) : this.scene.camera;
      this.scene.moveCamera(shifted(zoomed, -(now.x - last.x) * k, (now.y - last.y) * k));
    }
  }

  private readonly up = (event: PointerEvent): void => {
    this.pointers.delete(event.pointerId);
    this.letGo();
  };

  private letGo(): void {
    if (this.holds) this.scene.release();
    this.holds = false;
  }

  private readonly wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const lines =
      event.deltaMode === WheelEvent.DOM_DELTA_LINE
        ? 16
        : event.deltaMode === WheelEvent.DOM_DELTA_PAGE
          ? 300
          : 1;
    const factor = Math.exp(Math.max(-120, Math.min(120, event.deltaY * lines)) * 0.0015);
    this.scene.moveCamera(nearer(this.scene.camera, factor));
  };

  private readonly key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const camera = this.scene.camera;
    const far = event.shiftKey ? 30 * this.scene.metresPerPixel() : 0;
    const moves: Record<string, () => CameraState> = {
      ArrowLeft: () => (far ? shifted(camera, -far, 0) : turned(camera, perKey, 0)),
      ArrowRight: () => (far ? shifted(camera, far, 0) : turned(camera, -perKey, 0)),
      ArrowUp: () => (far ? shifted(camera, 0, far) : turned(camera, 0, perKey)),
      ArrowDown: () => (far ? shifted(camera, 0, -far) : turned(camera, 0, -perKey)),
      '+': () => nearer(camera, 1 / 1.15),
      '=': () => nearer(camera, 1 / 1.15),
      '-': () => nearer(camera, 1.15),
    };
    const moved = moves[event.key];
    if (moved) this.scene.moveCamera(moved());
    else if (event.key === 'Home' || event.key === '0') this.scene.reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  dispose(): void {
    this.letGo();
    this.stop.abort();
  }
}
