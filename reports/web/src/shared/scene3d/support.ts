// How far a shape reaches in a direction.
import type { Quaternion, Shape, Vector } from '../documents';
import { conjugate, dot, rotate } from './vectors';

const farthest = (points: Vector[], d: Vector): number =>
  points.reduce((reach, p) => Math.max(reach, dot(p, d)), -Infinity);

/** Largest d . x over the points x of a shape in its own axes [m]; d a unit vector.  No shape: a point. */
export function support(shape: Shape | null | undefined, d: Vector): number {
  if (!shape) return 0;
  const radial = Math.hypot(d[0], d[2]); // against the axis of revolution, y
  switch (shape.type) {
    case 'sphere':
      return shape.radius;
    case 'box':
      return shape.half_extents.reduce((sum, h, i) => sum + h * Math.abs(d[i]!), 0);
    case 'capsule':
      return shape.radius + (shape.length / 2) * Math.abs(d[1]);
    case 'cylinder':
      return shape.radius * radial + (shape.length / 2) * Math.abs(d[1]);
    case 'cone':
      return Math.max(0.75 * shape.length * d[1], shape.radius * radial - 0.25 * shape.length * d[1]);
    case 'rod':
      return (shape.length / 2) * Math.abs(d[1]);
    case 'disc':
      return shape.radius * radial;
    case 'hull':
    case 'mesh':
      return farthest(shape.vertices, d);
    case 'compound':
      return Math.max(
        ...shape.parts.map(
          (part) => dot(part.position, d) + support(part.shape, rotate(conjugate(part.orientation), d)),
        ),
      );
  }
}

/** How far a turned shape reaches from its centre to either side along axis i of the world [m]. */
export function reachAlong(
  shape: Shape | null | undefined,
  turn: Quaternion,
  axis: number,
): { down: number; up: number } {
  const along = (side: number): number => {
    const d: Vector = [0, 0, 0];
    d[axis] = side;
    return support(shape, rotate(conjugate(turn), d));
  };
  return { down: along(-1), up: along(1) };
}
