// What the pages know of a 3D picture.
import type { Scene, Vector } from '../documents';

export interface Pose {
  position: ArrayLike<number>; // 3 per body [m]
  orientation: ArrayLike<number>; // 4 per body: w, x, y, z
}

/** A camera on a sphere around a target, y up.  Azimuth 0 looks along -z, elevation 0 is level [rad]. */
export interface CameraState {
  target: Vector; // [m]
  distance: number; // [m]
  azimuth: number;
  elevation: number;
}

export type ArrowKind = 'velocity' | 'momentum' | 'angular momentum' | 'impulse' | 'normal';

export interface Arrow {
  at: Vector; // [m]
  along: Vector; // already scaled: world [m]
  kind: ArrowKind;
}

export interface ContactMark {
  point: Vector; // [m]
  normal: Vector;
  impulse: number | null; // [N s]
}

export interface Pull {
  from: Vector; // [m]
  to: Vector;
}

export interface Bounds {
  min: Vector; // [m]
  max: Vector;
}

export interface Grab {
  body: number;
  anchor: Vector; // body axes [m]
  point: Vector; // world [m]
}

export interface Scene3DOptions {
  label: string; // for screen readers
  bounds?: Bounds; // of the bodies' centres in the whole motion, to frame it; absent: as they are at t = 0
}

export type Layer = 'bodies' | 'ghost';

export interface Scene3D {
  readonly element: HTMLElement; // a focusable canvas
  readonly webgl: boolean; // false: an orthographic picture on a 2D canvas
  /** `ghost` is a translucent outline of the truth; time [s] moves water. */
  show(layer: Layer, pose: Pose | null, time: number): void;
  /** [frame][body][3] [m], drawn up to frame `upTo`.  An array may be filled further: a frame is read when
   * `upTo` first reaches it. */
  trails(layer: Layer, positions: Float32Array | null, bodies: number, upTo: number): void;
  arrows(list: Arrow[]): void;
  /** `largest`: the impulse [N s] whose arrow is a fifth of the scene long, one for compared pictures;
   * without it the largest that this picture has had. */
  contacts(list: ContactMark[], largest?: number): void;
  pulls(list: Pull[]): void; // springs by which somebody pulls
  /** Springs and joints, on at first. */
  links(shown: boolean): void;
  replaceScene(scene: Scene): void;
  camera: CameraState; // set it to link several views
  onCamera: ((state: CameraState) => void) | null; // the user moved it
  /** Frames these bounds [m] in place of the scene's, unless somebody chose the camera. */
  frameOn(bounds: Bounds): void;
  /** Nobody chose the camera: it frames all again. */
  frameAll(): void;
  onFrameAll: (() => void) | null; // the user asked for that; where it is not set, onCamera tells
  /** A drag began on a body; where this is not set, drags turn the camera. */
  onGrab: ((grab: Grab) => void) | null;
  /** The point under the pointer in the plane through the grab that faces the camera. */
  onPull: ((point: Vector) => void) | null;
  onRelease: (() => void) | null;
  render(): void; // draws now if anything changed; the caller calls it once per animation frame
  /** Draws now, and what is drawn into another canvas at (x, y) [device px]. */
  paint(context: CanvasRenderingContext2D, x: number, y: number): void;
  readonly size: { width: number; height: number }; // of what paint() draws [device px]
  png(): Promise<Blob>; // what is drawn
  dispose(): void;
}
