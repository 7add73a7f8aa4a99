// Which body a ray meets first.
import type { Vector } from '../documents';
import type { Bodies } from './picture';
import type { Solids } from './solids';
import { add, conjugate, dot, multiply, rotate, scale, subtract } from './vectors';

export interface Ray {
  from: Vector; // [m]
  along: Vector;
}

/** Part s of the ray to a ball about the origin, |from + s along| = radius; null where it misses. */
export function meetBall({ from, along }: Ray, radius: number): number | null {
  const a = dot(along, along);
  const b = dot(from, along);
  const root = b * b - a * (dot(from, from) - radius * radius);
  if (!(root >= 0)) return null;
  const s = (-b - Math.sqrt(root)) / a;
  return s >= 0 ? s : null;
}

/** The same for a box about the origin: the last entry into its slabs, if it comes before the first exit. */
export function meetBox({ from, along }: Ray, half: Vector): number | null {
  let enter = 0;
  let exit = Infinity;
  for (let i = 0; i < 3; ++i) {
    if (along[i] === 0) {
      if (Math.abs(from[i]!) > half[i]!) return null;
      continue;
    }
    const near = (-Math.sign(along[i]!) * half[i]! - from[i]!) / along[i]!;
    const far = (Math.sign(along[i]!) * half[i]! - from[i]!) / along[i]!;
    enter = Math.max(enter, near);
    exit = Math.min(exit, far);
  }
  return enter <= exit && exit > 0 ? enter : null;
}

/** The nearest body and the point where the ray meets it; `least(depth)` is the half extent [m] that every
 * body has at least for a finger or a mouse. */
export function pick(
  ray: Ray,
  solids: Solids,
  bodies: Bodies,
  least: (depth: number) => number,
): { body: number; point: Vector } | null {
  let best: { body: number; s: number } | null = null;
  for (const piece of solids.pieces) {
    const { body } = piece;
    if (bodies.hidden[body]) continue;
    const turn = bodies.turn(body);
    const centre = add(bodies.at(body), rotate(turn, piece.position));
    const back = conjugate(multiply(turn, piece.orientation));
    const local: Ray = { from: rotate(back, subtract(ray.from, centre)), along: rotate(back, ray.along) };
    const depth = -dot(local.from, local.along) / Math.hypot(...ray.along);
    const small = least(Math.max(depth, 0));
    const s =
      piece.mold === 'sphere' || Math.max(...piece.half) < small
        ? meetBall(local, Math.max(piece.half[0], small))
        : meetBox(local, piece.half.map((h) => Math.max(h, small)) as Vector);
    if (s !== null && (!best || s < best.s)) best = { body, s };
  }
  return best && { body: best.body, point: add(ray.from, scale(ray.along, best.s)) };
}
