// Shapes as meshes of unit size that instances stretch: position * size + lift * length along y.  Every
// triangle has a tone, so that one sees a body turn: six tones on flat faces, sectors on round ones.
import { ConvexHull } from 'three/examples/jsm/math/ConvexHull.js';
import { Vector3 } from 'three';

import type { Vector } from '../documents';
import { cross, dot, length, scale, subtract, unit } from './vectors';

export interface Mold {
  position: number[]; // 3 per corner, 3 corners per triangle
  normal: number[];
  tone: number[]; // 1 per corner
  lift: number[]; // 1 per corner: -1, 0 or 1
  edges: number[]; // 4 per end of a line: position and lift
}

const empty = (): Mold => ({ position: [], normal: [], tone: [], lift: [], edges: [] });
const dim = 0.66;

/** Six tones of one colour, as faces in the order +x -x +y -y +z -z: (1 + (i + 1)/6)/2. */
export function faceTone(n: Vector): number {
  const size = n.map(Math.abs) as Vector;
  const axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
  const order = [5, 1, 4, 2, 3, 0][2 * axis + (n[axis]! < 0 ? 1 : 0)]!;
  return 0.5 * (1 + (order + 1) / 6);
}

function corner(mold: Mold, p: Vector, n: Vector, tone: number, lift = 0): void {
  mold.position.push(...p);
  mold.normal.push(...n);
  mold.tone.push(tone);
  mold.lift.push(lift);
}

function line(mold: Mold, a: Vector, b: Vector, liftA = 0, liftB = liftA): void {
  mold.edges.push(...a, liftA, ...b, liftB);
}

const angle = (i: number, n: number): Vector => [
  Math.cos((2 * Math.PI * i) / n),
  0,
  Math.sin((2 * Math.PI * i) / n),
];

/** The eighths of a ball, each of rows^2 triangles; halves may be lifted apart for a capsule. */
function ball(mold: Mold, rows: number, lifted: boolean): void {
  for (let octant = 0; octant < 8; ++octant) {
    const [sx, sy, sz] = [octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1];
    const tone = sx * sy * sz > 0 ? 1 : dim;
    const at = (i: number, j: number): Vector => unit([sx * (rows - i - j), sy * i, sz * j], [0, 1, 0]);
    const triangle = (a: Vector, b: Vector, c: Vector): void => {
      const outward = sx * sy * sz > 0 ? [a, b, c].reverse() : [a, b, c];
      for (const p of outward) corner(mold, p, p, tone, lifted ? sy : 0);
    };
    for (let i = 0; i < rows; ++i)
      for (let j = 0; j < rows - i; ++j) {
        triangle(at(i, j), at(i, j + 1), at(i + 1, j));
        if (i + j + 2 <= rows) triangle(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
      }
  }
}

function sphere(rows: number): Mold {
  const mold = empty();
  ball(mold, rows, false);
  const pieces = 6 * rows;
  for (let i = 0; i < pieces; ++i) {
    const [a, b] = [angle(i, pieces), angle(i + 1, pieces)];
    line(mold, a, b);
    line(mold, [a[0], a[2], 0], [b[0], b[2], 0]);
    line(mold, [0, a[0], a[2]], [0, b[0], b[2]]);
  }
  return mold;
}

function capsule(rows: number): Mold {
  const mold = empty();
  ball(mold, rows, true);
  const sides = 8 * rows;
  for (let i = 0; i < sides; ++i) {
    const [a, b] = [angle(i, sides), angle(i + 1, sides)];
    const tone = Math.floor((4 * i) / sides) % 2 ? dim : 1;
    for (const [p, lift] of [
      [a, -1],
      [a, 1],
      [b, 1],
      [a, -1],
      [b, 1],
      [b, -1],
    ] as [Vector, number][])
      corner(mold, p, p, tone, lift);
    line(mold, a, b, 1);
    line(mold, a, b, -1);
  }
  for (let i = 0; i < 24; ++i) {
    const [a, b] = [angle(i, 48), angle(i + 1, 48)]; // half a circle: over the top, then below
    for (const s of [1, -1]) {
      line(mold, [a[0], s * a[2], 0], [b[0], s * b[2], 0], s);
      line(mold, [0, s * a[2], a[0]], [0, s * b[2], b[0]], s);
    }
  }
  for (let i = 0; i < 4; ++i) line(mold, angle(i, 4), angle(i, 4), -1, 1);
  return mold;
}

/** Between two heights; radius 1 below, `top` above. */
function turned(sides: number, low: number, high: number, top: number): Mold {
  const mold = empty();
  const slope = (1 - top) / (high - low);
  for (let i = 0; i < sides; ++i) {
    const tone = Math.floor((4 * i) / sides) % 2 ? dim : 1;
    const [a, b] = [angle(i, sides), angle(i + 1, sides)];
    const at = (p: Vector, k: number, y: number): Vector => [k * p[0], y, k * p[2]];
    const normal = (p: Vector): Vector => unit([p[0], slope, p[2]], p);
    if (high > low) {
      for (const [p, y] of [
        [a, low],
        [a, high],
        [b, high],
        [a, low],
        [b, high],
        [b, low],
      ] as [Vector, number][])
        corner(mold, at(p, y === high ? top : 1, y), normal(p), tone);
    }
    for (const p of [[0, low, 0], at(a, 1, low), at(b, 1, low)] as Vector[])
      corner(mold, p, [0, -1, 0], 0.8 * tone);
    line(mold, at(a, 1, low), at(b, 1, low));
    if (top > 0) {
      for (const p of [[0, high, 0], at(b, top, high), at(a, top, high)] as Vector[])
        corner(mold, p, [0, 1, 0], 0.9 * tone);
      line(mold, at(a, top, high), at(b, top, high));
    }
  }
  for (let i = 0; i < 4; ++i) {
    const p = angle(i, 4);
    line(mold, [p[0], low, p[2]], [top * p[0], high, top * p[2]]);
  }
  return mold;
}

/** Lines where faces meet at more than 20 degrees, or where a mesh ends. */
function creases(mold: Mold): void {
  const seen = new Map<string, { n: Vector; drawn: boolean; a: Vector; b: Vector; count: number }>();
  const name = (p: Vector): string => p.map((x) => Math.fround(x)).join();
  for (let t = 0; t < mold.position.length; t += 9) {
    const p = [0, 1, 2].map((i) => mold.position.slice(t + 3 * i, t + 3 * i + 3) as Vector);
    const n = unit(cross(subtract(p[1]!, p[0]!), subtract(p[2]!, p[0]!)), [0, 1, 0]);
    for (let i = 0; i < 3; ++i) {
      const [a, b] = [p[i]!, p[(i + 1) % 3]!];
      const key = name(a) < name(b) ? `${name(a)} ${name(b)}` : `${name(b)} ${name(a)}`;
      const other = seen.get(key);
      if (!other) seen.set(key, { n, drawn: false, a, b, count: 1 });
      else {
        ++other.count;
        if (dot(n, other.n) < Math.cos(Math.PI / 9) && !other.drawn) {
          other.drawn = true;
          line(mold, a, b);
        }
      }
    }
  }
  for (const edge of seen.values()) if (edge.count === 1) line(mold, edge.a, edge.b);
}

/** Flat faces, counter-clockwise from outside. */
export function faceted(triangles: [Vector, Vector, Vector][]): Mold {
  const mold = empty();
  for (const [a, b, c] of triangles) {
    const n = unit(cross(subtract(b, a), subtract(c, a)), [0, 0, 0]);
    if (length(n) === 0) continue;
    for (const p of [a, b, c]) corner(mold, p, n, faceTone(n));
  }
  creases(mold);
  return mold;
}

/** Triangles of the convex hull of points, counter-clockwise from outside; none where they lie in a plane. */
export function hullTriangles(points: Vector[]): [Vector, Vector, Vector][] {
  const good = points.filter((p) => p.every(Number.isFinite));
  const triangles: [Vector, Vector, Vector][] = [];
  if (good.length < 4) return triangles;
  for (const face of new ConvexHull().setFromPoints(good.map((p) => new Vector3(...p))).faces) {
    const corners: Vector[] = [];
    let edge = face.edge;
    do {
      const p = edge.head().point;
      corners.push([p.x, p.y, p.z]);
      edge = edge.next;
    } while (edge !== face.edge);
    for (let i = 2; i < corners.length; ++i) triangles.push([corners[0]!, corners[i - 1]!, corners[i]!]);
  }
  return triangles;
}

function box(): Mold {
  const triangles: [Vector, Vector, Vector][] = [];
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [1, -1]) {
      const at = (u: number, v: number): Vector => {
        const p: Vector = [0, 0, 0];
        p[axis] = side;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v * side;
        return p;
      };
      triangles.push([at(-1, -1), at(1, -1), at(1, 1)], [at(-1, -1), at(1, 1), at(-1, 1)]);
    }
  return faceted(triangles);
}

/** Three bars from a cube, the positive halves twice as long, for a point or a bare body. */
function axisCross(): Mold {
  const mold = box();
  mold.position = mold.position.map((p) => 0.3 * p);
  mold.edges = [];
  for (let axis = 0; axis < 3; ++axis) {
    const bar = box();
    for (let i = 0; i < bar.position.length; ++i) {
      const along = i % 3 === axis;
      const p = bar.position[i]!;
      bar.position[i] = along ? (p > 0 ? 1 : -0.5) : 0.09 * p;
    }
    mold.position.push(...bar.position);
    mold.normal.push(...bar.normal);
    mold.tone.push(...bar.tone.map((t) => [1, 0.8, 0.6][axis]! * (0.5 + 0.5 * t)));
    mold.lift.push(...bar.lift);
    const [a, b]: [Vector, Vector] = [
      [0, 0, 0],
      [0, 0, 0],
    ];
    a[axis] = -0.5;
    b[axis] = 1;
    line(mold, a, b);
  }
  return mold;
}

export type MoldKind = 'sphere' | 'box' | 'capsule' | 'cylinder' | 'cone' | 'disc' | 'cross';

/** `many`: how many bodies the picture has; with more of them each gets fewer triangles. */
export function makeMold(kind: MoldKind, many: number): Mold {
  const rows = many <= 60 ? 8 : many <= 300 ? 5 : 3;
  const sides = 4 * rows;
  const make: Record<MoldKind, () => Mold> = {
    sphere: () => sphere(rows),
    box,
    capsule: () => capsule(rows),
    cylinder: () => turned(sides, -1, 1, 1),
    cone: () => turned(sides, -0.25, 0.75, 0),
    disc: () => turned(sides, 0, 0, 1),
    cross: axisCross,
  };
  return make[kind]();
}

/** The box of a mesh about the origin: its half extents. */
export function reach(points: Vector[]): Vector {
  return points.reduce<Vector>(
    (most, p) => most.map((m, i) => Math.max(m, Math.abs(p[i]!))) as Vector,
    scale([1, 1, 1], 0),
  );
}
