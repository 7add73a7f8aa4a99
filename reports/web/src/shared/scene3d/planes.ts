// Planes as grids over what is in sight, with short strokes and an arrow towards the solid side.
import type { Scene, Vector } from '../documents';
import { round125 } from './bounds';
import { mix } from './colours';
import type { Theme } from './colours';
import { arrow } from './marks';
import type { Segments } from './segments';
import type { Bounds } from './types';
import { add, dot, length, scale, subtract, tangents, unit } from './vectors';

/** The part of the plane normal . x = offset within a box: a convex polygon, empty where they do not meet. */
export function planeInBox(normal: Vector, offset: number, box: Bounds): Vector[] {
  const middle = scale(add(box.min, box.max), 0.5);
  const size = length(subtract(box.max, box.min));
  const centre = add(middle, scale(normal, offset - dot(normal, middle)));
  const [u, v] = tangents(normal);
  let polygon: Vector[] = (
    [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ] as const
  ).map(([a, b]) => add(centre, add(scale(u, a * size), scale(v, b * size))));
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [1, -1]) {
      const out: Vector = [0, 0, 0];
      out[axis] = side;
      polygon = cut(polygon, out, side > 0 ? box.max[axis]! : -box.min[axis]!);
    }
  return polygon;
}

/** The part of a convex polygon where out . x <= limit. */
export function cut(polygon: Vector[], out: Vector, limit: number): Vector[] {
  return polygon.flatMap((p, i) => {
    const q = polygon[(i + 1) % polygon.length]!;
    const [a, b] = [dot(p, out) - limit, dot(q, out) - limit];
    const crossing = a * b < 0 ? [add(p, scale(subtract(q, p), a / (a - b)))] : [];
    return a <= 0 ? [p, ...crossing] : crossing;
  });
}

/** The piece of the line { p : p . across = c } within a convex polygon, seen along the plane. */
export function chord(polygon: Vector[], across: Vector, c: number): [Vector, Vector] | null {
  const cuts: Vector[] = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length]!;
    const [a, b] = [dot(p, across) - c, dot(q, across) - c];
    if (a <= 0 !== b <= 0) cuts.push(add(p, scale(subtract(q, p), a / (a - b))));
  });
  return cuts.length >= 2 ? [cuts[0]!, cuts[1]!] : null;
}

/** Distance of the lines of a grid [m]. */
export const gridStep = (extent: number): number => round125(extent / 8);

/** Which planes show an eye their free side: the others would stand between it and the bodies. */
export const facing = (scene: Scene, eye: Vector): boolean[] =>
  scene.plane.map((plane) => dot(plane.normal, eye) >= plane.offset);

/** Planes that are not `open` are drawn as a border alone. */
export function drawPlanes(
  into: Segments,
  scene: Scene,
  bounds: Bounds,
  theme: Theme,
  open: boolean[],
): void {
  const extent = length(subtract(bounds.max, bounds.min));
  const room = 0.18 * extent;
  const box: Bounds = {
    min: subtract(bounds.min, [room, room, room]),
    max: add(bounds.max, [room, room, room]),
  };
  const border = mix(theme.ground, theme.ink, 0.5);
  scene.plane.forEach((plane, which) => {
    const n = unit(plane.normal, [0, 1, 0]);
    // What lies within the solid of another plane cannot be seen: planes about a room are its walls.
    const polygon = scene.plane.reduce(
      (rest, other) => (other === plane ? rest : cut(rest, scale(other.normal, -1), -other.offset)),
      planeInBox(n, plane.offset, box),
    );
    if (polygon.length < 3) return;
    if (!open[which]) {
      polygon.forEach((p, i) => into.add(p, polygon[(i + 1) % polygon.length]!, theme.faint, 1));
      return;
    }
    const step = gridStep(extent);
    for (const across of tangents(n)) {
      const reach = polygon.map((p) => dot(p, across));
      const last = Math.floor(Math.max(...reach) / step);
      for (let k = Math.ceil(Math.min(...reach) / step); k <= last; ++k) {
        const line = chord(polygon, across, k * step);
        if (line) into.add(line[0], line[1], theme.faint, 1);
      }
    }
    // Strokes along the border lean into the solid, as ground is drawn by hand.
    const tick = 0.25 * step;
    polygon.forEach((p, i) => {
      const q = polygon[(i + 1) % polygon.length]!;
      into.add(p, q, border, 1);
      const side = subtract(q, p);
      const count = Math.floor(length(side) / (step / 2));
      const lean = add(scale(n, -tick), scale(unit(side, [0, 0, 0]), -tick));
      for (let k = 1; k <= count; ++k) {
        const at = add(p, scale(side, (k - 0.5) / count));
        into.add(at, add(at, lean), border, 1);
      }
    });
    const corner = polygon.reduce((sum, p) => add(sum, scale(p, 1 / polygon.length)), [0, 0, 0] as Vector);
    const at = add(corner, scale(subtract(polygon[0]!, corner), 0.8));
    arrow(into, at, scale(n, -0.07 * extent), border, 2, extent);
  });
}
