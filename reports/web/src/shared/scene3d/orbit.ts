// The orbit camera: where it stands, what it sees, how it frames a box.  Pure; both ways of drawing use it.
import type { Vector } from '../documents';
import type { Bounds, CameraState } from './types';
import { add, cross, dot, scale, subtract } from './vectors';

export const fieldOfView = (40 * Math.PI) / 180; // vertical [rad]
const steepest = Math.PI / 2 - 1e-3; // [rad], so that up stays up

export interface View {
  eye: Vector; // [m]
  right: Vector;
  up: Vector;
  back: Vector; // from target to eye, unit
  target: Vector;
  distance: number; // [m]
  width: number; // of the picture [css px]
  height: number;
  ratio: number; // device pixels per css px
  near: number; // [m]
  far: number;
}

export function clampCamera(camera: CameraState): CameraState {
  return {
    target: [...camera.target],
    distance: Math.min(Math.max(camera.distance, 1e-6), 1e15),
    azimuth: camera.azimuth % (2 * Math.PI),
    elevation: Math.min(Math.max(camera.elevation, -steepest), steepest),
  };
}

/** right, up, back of a camera. */
export function axes(camera: CameraState): [Vector, Vector, Vector] {
  const { azimuth: a, elevation: e } = camera;
  const back: Vector = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
  const right: Vector = [Math.cos(a), 0, -Math.sin(a)];
  return [right, cross(back, right), back];
}

/** `extent`: size [m] of what is to be seen.  What is nearer than a hundredth of the way to the target is cut
 * off; 24 bits of depth then tell points apart that differ by 1e-5 of it. */
export function viewOf(
  camera: CameraState,
  size: { width: number; height: number; ratio: number },
  extent: number,
): View {
  const [right, up, back] = axes(camera);
  const { target, distance } = camera;
  const far = 5 * distance + 20 * extent;
  const near = Math.max(0.01 * distance, 1e-5 * far);
  return { eye: add(target, scale(back, distance)), right, up, back, target, distance, near, far, ...size };
}

/** [m] per css px at the depth of the target. */
export const metresPerPixel = (view: View): number =>
  (2 * view.distance * Math.tan(fieldOfView / 2)) / view.height;

/** Where a perspective camera draws a point [css px] and how deep it lies [m]; null behind the camera. */
export function project(view: View, p: Vector): { x: number; y: number; depth: number } | null {
  const d = subtract(p, view.eye);
  const depth = -dot(d, view.back);
  if (!(depth > view.near)) return null;
  const k = view.height / 2 / Math.tan(fieldOfView / 2) / depth;
  return { x: view.width / 2 + k * dot(d, view.right), y: view.height / 2 - k * dot(d, view.up), depth };
}

/** The ray of a perspective camera through a point of the picture [css px]; `along` goes 1 m deep. */
export function rayThrough(view: View, x: number, y: number): { from: Vector; along: Vector } {
  const k = Math.tan(fieldOfView / 2) / (view.height / 2);
  const along = add(scale(view.right, (x - view.width / 2) * k), scale(view.up, (view.height / 2 - y) * k));
  return { from: view.eye, along: subtract(along, view.back) };
}

/** The same of an orthographic camera that shows the target's surroundings at the same size. */
export function parallelRay(view: View, x: number, y: number): { from: Vector; along: Vector } {
  const k = metresPerPixel(view);
  const aside = add(scale(view.right, (x - view.width / 2) * k), scale(view.up, (view.height / 2 - y) * k));
  return { from: add(view.eye, aside), along: scale(view.back, -1) };
}

/** Where an orthographic camera draws a point. */
export function projectParallel(view: View, p: Vector): { x: number; y: number; depth: number } {
  const d = subtract(p, view.target);
  const k = 1 / metresPerPixel(view);
  return {
    x: view.width / 2 + k * dot(d, view.right),
    y: view.height / 2 - k * dot(d, view.up),
    depth: view.distance - dot(d, view.back),
  };
}

/** A camera that has the whole box in its picture, from the side where a flat motion is seen best. */
export function frame(bounds: Bounds, aspect: number): CameraState {
  const middle = scale(add(bounds.min, bounds.max), 0.5);
  const half = scale(subtract(bounds.max, bounds.min), 0.5);
  const flat = half[2] < 0.4 * Math.max(half[0], half[1]);
  const camera: CameraState = {
    target: middle,
    distance: 1,
    azimuth: flat ? 0.25 : 0.55,
    elevation: flat ? 0.16 : 0.3,
  };
  const [right, up, back] = axes(camera);
  const vertical = Math.tan(fieldOfView / 2);
  const horizontal = vertical * aspect;
  let distance = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const c: Vector = [
      corner & 1 ? half[0] : -half[0],
      corner & 2 ? half[1] : -half[1],
      corner & 4 ? half[2] : -half[2],
    ];
    // Seen within the picture where |side| <= (distance - towards the eye) tan.
    const needed = Math.max(Math.abs(dot(c, right)) / horizontal, Math.abs(dot(c, up)) / vertical);
    distance = Math.max(distance, needed + dot(c, back));
  }
  camera.distance = distance > 0 ? 1.06 * distance : 5;
  return camera;
}
