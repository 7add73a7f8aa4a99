// What is drawn of a bare rigid body, which has inertia but no shape: the box of its mass and inertia.
import type { Quaternion, Scene, Shape, Vector } from '../documents';
import { multiply } from './vectors';

type Matrix = [Vector, Vector, Vector];

/** Moments and axes (body to principal axes undone: a turn from the principal axes to the body's) of a symmetric
 * matrix, by Jacobi's rotations. */
export function principalAxes(inertia: number[]): { moments: Vector; turn: Quaternion } {
  const a = [0, 1, 2].map((i) => inertia.slice(3 * i, 3 * i + 3)) as Matrix;
  let turn: Quaternion = [1, 0, 0, 0];
  for (let sweep = 0; sweep < 12; ++sweep)
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]] as const) {
      const off = (a[p]![q]! + a[q]![p]!) / 2;
      if (!(Math.abs(off) > 1e-15 * (Math.abs(a[p]![p]!) + Math.abs(a[q]![q]!)))) continue;
      // The angle that makes a_pq zero: tan 2 phi = 2 a_pq / (a_pp - a_qq).
      const phi = Math.atan2(2 * off, a[p]![p]! - a[q]![q]!) / 2;
      const [c, s] = [Math.cos(phi), Math.sin(phi)];
      for (let k = 0; k < 3; ++k) [a[k]![p], a[k]![q]] = [c * a[k]![p]! + s * a[k]![q]!, c * a[k]![q]! - s * a[k]![p]!];
      for (let k = 0; k < 3; ++k) [a[p]![k], a[q]![k]] = [c * a[p]![k]! + s * a[q]![k]!, c * a[q]![k]! - s * a[p]![k]!];
      // From p to q is with the right hand about the third axis, but for the pair (0, 2).
      const axis = 3 - p - q;
      const part: Quaternion = [Math.cos(phi / 2), 0, 0, 0];
      part[1 + axis] = Math.sin(phi / 2) * (axis === 1 ? -1 : 1);
      turn = multiply(turn, part);
    }
  return { moments: [a[0][0], a[1][1], a[2][2]], turn };
}

const thinnest = 0.04; // of the longest side: a flat body has no thickness

/** The shape to draw: the body's own, or else the box of its mass and inertia; null where that says nothing of how
 * the body lies (a point, or three equal moments). */
export function drawnShape(body: Scene['body'][number]): Shape | null {
  if (body.shape) return body.shape;
  const { moments, turn } = principalAxes(body.inertia);
  const [a, b, c] = moments;
  const largest = Math.max(a, b, c);
  if (!(body.mass > 0) || !(largest > 0) || !Number.isFinite(largest / body.mass)) return null;
  if (largest - Math.min(a, b, c) <= 1e-9 * largest) return null;
  // I_a = m/3 (h_b^2 + h_c^2), so h_a^2 = 3/(2 m) (I_b + I_c - I_a).
  const half = [b + c - a, c + a - b, a + b - c].map((d) => Math.sqrt(Math.max(0, (1.5 * d) / body.mass)));
  const least = thinnest * Math.max(...half);
  const box: Shape = { type: 'box', half_extents: half.map((h) => Math.max(h, least)) as Vector };
  if (turn[0] === 1) return box;
  return { type: 'compound', parts: [{ shape: box, mass: body.mass, position: [0, 0, 0], orientation: turn }] };
}
