// The bodies of a scene as instances of molds: which mold, how large, where on its body.
import type { Quaternion, Scene, Shape, Vector } from '../documents';
import { faceted, hullTriangles, makeMold, reach } from './molds';
import type { Mold, MoldKind } from './molds';
import { drawnShape } from './stand_in';
import { add, length, multiply, rotate } from './vectors';

/** One convex or meshed piece of a body. */
export interface Piece {
  body: number;
  mold: string; // key of `Solids.molds`
  size: [number, number, number, number]; // x, y, z and lift [m]
  half: Vector; // half extents of a box about the piece's origin that holds it [m]
  position: Vector; // body axes [m]
  orientation: Quaternion; // piece to body
}

export interface Solids {
  molds: Map<string, Mold>;
  pieces: Piece[];
  radius: number[]; // per body: of a ball about its centre that holds it [m]
}

const upright: Quaternion = [1, 0, 0, 0];
const thin = -1; // in place of the lift, which crosses do not have: they stay in sight at a larger size
const all = (x: number): Vector => [x, x, x];

/** `mark`: half length [m] of the cross that stands for what has no shape. */
export function solidsOf(scene: Scene, mark: number): Solids {
  const solids: Solids = { molds: new Map(), pieces: [], radius: [] };
  const many = scene.body.length;

  const put = (
    body: number,
    kind: MoldKind,
    size: Piece['size'],
    half: Vector,
    at: Vector,
    turn: Quaternion,
  ): void => {
    if (!solids.molds.has(kind)) solids.molds.set(kind, makeMold(kind, many));
    solids.pieces.push({ body, mold: kind, size, half, position: at, orientation: turn });
  };
  const cut = (
    body: number,
    key: string,
    mold: () => Mold,
    half: Vector,
    at: Vector,
    turn: Quaternion,
  ): void => {
    if (!solids.molds.has(key)) solids.molds.set(key, mold());
    if (solids.molds.get(key)!.position.length === 0)
      put(body, 'cross', [...all(length(half) || mark), thin], half, at, turn);
    else solids.pieces.push({ body, mold: key, size: [1, 1, 1, 0], half, position: at, orientation: turn });
  };

  const place = (body: number, shape: Shape | null | undefined, at: Vector, turn: Quaternion): void => {
    if (!shape) return put(body, 'cross', [...all(mark), thin], all(mark), at, turn);
    switch (shape.type) {
      case 'sphere':
        return put(body, 'sphere', [...all(shape.radius), 0], all(shape.radius), at, turn);
      case 'box':
        return put(body, 'box', [...shape.half_extents, 0], shape.half_extents, at, turn);
      case 'capsule': {
        const { radius: r, length: l } = shape;
        return put(body, 'capsule', [r, r, r, l / 2], [r, r + l / 2, r], at, turn);
      }
      case 'cylinder': {
        const { radius: r, length: l } = shape;
        return put(body, 'cylinder', [r, l / 2, r, 0], [r, l / 2, r], at, turn);
      }
      case 'cone': {
        const { radius: r, length: l } = shape;
        return put(body, 'cone', [r, l, r, 0], [r, 0.75 * l, r], at, turn);
      }
      case 'rod': {
        // Without thickness in the scene; drawn as a thin bar.
        const wide = 0.012 * shape.length;
        return put(
          body,
          'cylinder',
          [wide, shape.length / 2, wide, 0],
          [wide, shape.length / 2, wide],
          at,
          turn,
        );
      }
      case 'disc':
        return put(
          body,
          'disc',
          [...all(shape.radius), 0],
          [shape.radius, 0.02 * shape.radius, shape.radius],
          at,
          turn,
        );
      case 'hull':
        return cut(
          body,
          `hull ${shape.vertices.join()}`,
          () => faceted(hullTriangles(shape.vertices)),
          reach(shape.vertices),
          at,
          turn,
        );
      case 'mesh': {
        const corner = (i: number): Vector => shape.vertices[i] ?? [0, 0, 0];
        const triangles = (): Mold =>
          faceted(shape.faces.map(([a, b, c]) => [corner(a), corner(b), corner(c)]));
        return cut(
          body,
          `mesh ${shape.vertices.join()} ${shape.faces.join()}`,
          triangles,
          reach(shape.vertices),
          at,
          turn,
        );
      }
      case 'compound':
        for (const part of shape.parts)
          place(body, part.shape, add(at, rotate(turn, part.position)), multiply(turn, part.orientation));
    }
  };
  scene.body.forEach((body, i) => place(i, drawnShape(body), [0, 0, 0], upright));
  solids.radius = scene.body.map(() => 0);
  for (const p of solids.pieces)
    solids.radius[p.body] = Math.max(solids.radius[p.body]!, length(p.position) + length(p.half));
  return solids;
}

/** Pieces in the order in which a layer's arrays hold them: mold after mold. */
export function byMold(solids: Solids): Map<string, Piece[]> {
  const groups = new Map<string, Piece[]>();
  for (const piece of solids.pieces) {
    const group = groups.get(piece.mold);
    if (group) group.push(piece);
    else groups.set(piece.mold, [piece]);
  }
  return groups;
}
