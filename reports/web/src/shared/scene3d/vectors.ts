// Vectors and unit quaternions (w, x, y, z), active, body to world.  Nothing here knows of pictures.
import type { Quaternion, Vector } from '../documents';

export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vector, k: number): Vector => [k * a[0], k * a[1], k * a[2]];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vector): number => Math.hypot(a[0], a[1], a[2]);
export const finite = (a: ArrayLike<number>): boolean => {
  for (let i = 0; i < a.length; ++i) if (!Number.isFinite(a[i])) return false;
  return true;
};

/** a / |a|; `otherwise` where a is zero or not finite. */
export function unit(a: Vector, otherwise: Vector): Vector {
  const l = length(a);
  return l > 0 && Number.isFinite(l) ? scale(a, 1 / l) : otherwise;
}

/** Two unit vectors that complete the unit vector n to a right-handed frame (first, second, n). */
export function tangents(n: Vector): [Vector, Vector] {
  // The axis that n is farthest from: the cross product keeps its digits.
  const [x, y, z] = [Math.abs(n[0]), Math.abs(n[1]), Math.abs(n[2])];
  const axis: Vector = x <= y && x <= z ? [1, 0, 0] : z <= y ? [0, 0, 1] : [0, 1, 0];
  const second = unit(cross(n, axis), [0, 1, 0]);
  return [cross(second, n), second];
}

/** Turns v by q.  v' = v + 2 u x (u x v + w v), with q = (w, u). */
export function rotate(q: Quaternion, v: Vector): Vector {
  const u: Vector = [q[1], q[2], q[3]];
  return add(v, scale(cross(u, add(cross(u, v), scale(v, q[0]))), 2));
}

export const conjugate = (q: Quaternion): Quaternion => [q[0], -q[1], -q[2], -q[3]];

/** First r, then q. */
export const multiply = (q: Quaternion, r: Quaternion): Quaternion => [
  q[0] * r[0] - q[1] * r[1] - q[2] * r[2] - q[3] * r[3],
  q[0] * r[1] + q[1] * r[0] + q[2] * r[3] - q[3] * r[2],
  q[0] * r[2] - q[1] * r[3] + q[2] * r[0] + q[3] * r[1],
  q[0] * r[3] + q[1] * r[2] - q[2] * r[1] + q[3] * r[0],
];
