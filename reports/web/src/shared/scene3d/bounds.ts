// How far a scene reaches, from its initial state.
import type { Scene, Shape, Vector } from '../documents';
import { drawnShape } from './stand_in';
import { reachAlong } from './support';
import type { Bounds } from './types';
import { add, dot, finite, length, scale, subtract } from './vectors';

/** Radius [m] of a ball about the origin that holds a shape; 0 for none. */
export function shapeRadius(shape: Shape | null | undefined): number {
  if (!shape) return 0;
  switch (shape.type) {
    case 'sphere':
    case 'disc':
      return shape.radius;
    case 'box':
      return length(shape.half_extents);
    case 'capsule':
      return shape.radius + shape.length / 2;
    case 'cylinder':
      return Math.hypot(shape.radius, shape.length / 2);
    case 'cone':
      return Math.max(0.75 * shape.length, Math.hypot(shape.radius, shape.length / 4));
    case 'rod':
      return shape.length / 2;
    case 'hull':
    case 'mesh':
      return shape.vertices.reduce((most, v) => Math.max(most, length(v)), 0);
    case 'compound':
      return shape.parts.reduce(
        (most, part) => Math.max(most, length(part.position) + shapeRadius(part.shape)),
        0,
      );
  }
}

export function include(bounds: Bounds, p: Vector, radius: number): void {
  if (!finite(p) || !Number.isFinite(radius)) return;
  for (let i = 0; i < 3; ++i) {
    bounds.min[i] = Math.min(bounds.min[i]!, p[i]! - radius);
    bounds.max[i] = Math.max(bounds.max[i]!, p[i]! + radius);
  }
}

const nothing = (): Bounds => ({
  min: [Infinity, Infinity, Infinity],
  max: [-Infinity, -Infinity, -Infinity],
});

/** A box with some room in it, whatever the scene is. */
export function usable(bounds: Bounds): Bounds {
  if (!finite(bounds.min) || !finite(bounds.max)) return { min: [-1, -1, -1], max: [1, 1, 1] };
  const size = length(subtract(bounds.max, bounds.min));
  const least = size > 0 ? 0.04 * size : 0.5;
  const result: Bounds = { min: [...bounds.min], max: [...bounds.max] };
  for (let i = 0; i < 3; ++i) {
    const lack = least - (result.max[i]! - result.min[i]!);
    if (lack > 0) {
      result.min[i]! -= lack / 2;
      result.max[i]! += lack / 2;
    }
  }
  return result;
}

/** Makes room for a body whose centre comes everywhere in `centres`.  It may turn, unless it is locked; where
 * the centres lie in a plane or on a line, it is taken to keep its sides to that. */
function includeBody(bounds: Bounds, body: Scene['body'][number], centres: Bounds): void {
  if (!finite(centres.min) || !finite(centres.max) || !finite(body.orientation)) return;
  const shape = drawnShape(body);
  const radius = shapeRadius(shape);
  const ranges = centres.max.map((high, i) => high - centres.min[i]!);
  const widest = Math.max(...ranges);
  for (let i = 0; i < 3; ++i) {
    const still = body.locked || (widest > radius && ranges[i]! < 0.02 * widest);
    const { down, up } = still ? reachAlong(shape, body.orientation, i) : { down: radius, up: radius };
    if (!Number.isFinite(down + up)) continue;
    bounds.min[i] = Math.min(bounds.min[i]!, centres.min[i]! - down);
    bounds.max[i] = Math.max(bounds.max[i]!, centres.max[i]! + up);
  }
}

/** What there is to see: bodies, pins and joints, and the planes and waters near them.  `centres`: where the
 * centres of the bodies come in the whole motion; without it they are where they are at t = 0. */
export function sceneBounds(scene: Scene, centres?: Bounds): Bounds {
  const bounds = nothing();
  for (const body of scene.body) {
    const here: Bounds = { min: body.position, max: body.position };
    includeBody(bounds, body, body.locked ? here : (centres ?? here));
  }
  for (const spring of scene.spring) if (spring.pin) include(bounds, spring.pin, 0);
  for (const joint of scene.joint) if (joint.point) include(bounds, joint.point, 0);
  if (!finite(bounds.min)) return usable(bounds);
  const middle = scale(add(bounds.min, bounds.max), 0.5);
  const size = Math.max(length(subtract(bounds.max, bounds.min)), 1e-3);
  const near = (p: Vector): void => {
    if (length(subtract(p, middle)) < 6 * size) include(bounds, p, 0);
  };
  for (const plane of scene.plane)
    near(add(middle, scale(plane.normal, plane.offset - dot(plane.normal, middle))));
  for (const water of scene.water) near([middle[0], water.level, middle[2]]);
  return usable(bounds);
}

/** 1, 2 or 5 times a power of ten, at most x. */
export function round125(x: number): number {
  if (!(x > 0) || !Number.isFinite(x)) return 1;
  const power = 10 ** Math.floor(Math.log10(x));
  const k = x / power;
  return (k >= 5 ? 5 : k >= 2 ? 2 : 1) * power;
}
