// Bodies for the 2D canvas: balls as discs with their great circles, everything else by its faces.
import type { Quaternion, Vector } from '../documents';
import { css } from './colours';
import type { Mold } from './molds';
import { metresPerPixel, projectParallel } from './orbit';
import type { View } from './orbit';
import type { Bodies, Picture } from './picture';
import type { Piece } from './solids';
import type { Colour } from './segments';
import { add, dot, multiply, rotate, subtract } from './vectors';

export interface Item {
  depth: number; // [m]
  draw: (context: CanvasRenderingContext2D) => void;
}

interface Placed {
  centre: Vector; // [m]
  turn: Quaternion;
}

function placed(piece: Piece, bodies: Bodies): Placed {
  const turn = bodies.turn(piece.body);
  return {
    centre: add(bodies.at(piece.body), rotate(turn, piece.position)),
    turn: multiply(turn, piece.orientation),
  };
}

/** A mold's point where a piece has it in the world. */
function world(
  { centre, turn }: Placed,
  piece: Piece,
  x: number,
  y: number,
  z: number,
  lift: number,
): Vector {
  const [sx, sy, sz, sl] = piece.size;
  return add(centre, rotate(turn, [sx * x, sy * y + sl * lift, sz * z]));
}

const shaded = (colour: Colour, tone: number, light: number): string =>
  css(colour.map((c) => c * tone * light) as Colour);

/** Light as the WebGL picture has it: a lamp beside the camera. */
const lightOf = (view: View, n: Vector): number =>
  0.62 + 0.38 * (-0.34 * dot(n, view.right) + 0.63 * dot(n, view.up) + 0.68 * dot(n, view.back));

export function pieceItems(picture: Picture, view: View): Item[] {
  const items: Item[] = [];
  const bodies = picture.layers.bodies;
  const k = 1 / metresPerPixel(view);
  for (const piece of picture.solids.pieces) {
    if (bodies.hidden[piece.body]) continue;
    const where = placed(piece, bodies);
    const colour = picture.colours[piece.body]!;
    const { x, y, depth } = projectParallel(view, where.centre);
    const mold = picture.solids.molds.get(piece.mold)!;
    const radius = k * Math.max(...piece.half);
    if (radius < 2.5) items.push({ depth, draw: (c) => disc(c, x, y, 2.5, css(colour)) });
    else if (piece.mold === 'sphere')
      items.push({ depth, draw: (c) => ball(c, view, mold, piece, where, colour, x, y, radius) });
    else faces(items, view, mold, piece, where, colour);
  }
  return items;
}

function disc(c: CanvasRenderingContext2D, x: number, y: number, radius: number, fill: string): void {
  c.fillStyle = fill;
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fill();
}

function ball(
  c: CanvasRenderingContext2D,
  view: View,
  mold: Mold,
  piece: Piece,
  where: Placed,
  colour: Colour,
  x: number,
  y: number,
  radius: number,
): void {
  disc(c, x, y, radius, shaded(colour, 0.95, 0.85));
  if (radius < 5) return;
  c.strokeStyle = shaded(colour, 0.5, 0.9);
  c.lineWidth = Math.min(2, radius / 6);
  c.beginPath();
  halfEdges(c, view, mold, piece, where, true);
  c.stroke();
}

/** Lines of a mold; those on the far side left out where `near` says so. */
function halfEdges(
  c: CanvasRenderingContext2D,
  view: View,
  { edges }: Mold,
  piece: Piece,
  where: Placed,
  near: boolean,
): void {
  for (let i = 0; i < edges.length; i += 8) {
    const a = world(where, piece, edges[i]!, edges[i + 1]!, edges[i + 2]!, edges[i + 3]!);
    const b = world(where, piece, edges[i + 4]!, edges[i + 5]!, edges[i + 6]!, edges[i + 7]!);
    if (near && dot(subtract(add(a, b), add(where.centre, where.centre)), view.back) < 0) continue;
    const [p, q] = [projectParallel(view, a), projectParallel(view, b)];
    c.moveTo(p.x, p.y);
    c.lineTo(q.x, q.y);
  }
}

/** Faces that look at the camera, each an item of its own. */
function faces(items: Item[], view: View, mold: Mold, piece: Piece, where: Placed, colour: Colour): void {
  const [sx, sy, sz] = piece.size;
  const large = Math.max(...piece.half) > 10 * metresPerPixel(view);
  for (let corner = 0; corner < mold.tone.length; corner += 3) {
    const n = rotate(where.turn, [
      mold.normal[3 * corner]! / (sx || 1),
      mold.normal[3 * corner + 1]! / (sy || 1),
      mold.normal[3 * corner + 2]! / (sz || 1),
    ]);
    const l = Math.hypot(...n) || 1;
    const p = [0, 1, 2].map((i) => {
      const at = 3 * (corner + i);
      return projectParallel(
        view,
        world(
          where,
          piece,
          mold.position[at]!,
          mold.position[at + 1]!,
          mold.position[at + 2]!,
          mold.lift[corner + i]!,
        ),
      );
    });
    const [a, b, d] = p as [(typeof p)[0], (typeof p)[0], (typeof p)[0]];
    // Counter-clockwise from outside, with y downwards on the screen.
    if ((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x) >= 0) continue;
    const fill = shaded(colour, mold.tone[corner]!, lightOf(view, [n[0] / l, n[1] / l, n[2] / l]));
    items.push({
      depth: (a.depth + b.depth + d.depth) / 3,
      draw: (c) => {
        c.fillStyle = fill;
        c.beginPath();
        for (const { x, y } of p) c.lineTo(x, y);
        c.closePath();
        c.fill();
        if (!large) return;
        c.strokeStyle = fill; // closes the seam between neighbours
        c.lineWidth = 0.7;
        c.stroke();
      },
    });
  }
}

/** The ghost: dashed edges, balls as dashed circles. */
export function outlines(picture: Picture, view: View, c: CanvasRenderingContext2D): void {
  const bodies = picture.layers.ghost;
  c.strokeStyle = css(picture.theme.ink);
  c.lineWidth = 1;
  c.setLineDash([4, 3]);
  c.beginPath();
  for (const piece of picture.solids.pieces) {
    if (bodies.hidden[piece.body]) continue;
    const where = placed(piece, bodies);
    const { x, y } = projectParallel(view, where.centre);
    if (piece.mold === 'sphere') {
      const radius = Math.max(piece.half[0] / metresPerPixel(view), 4);
      c.moveTo(x + radius, y);
      c.arc(x, y, radius, 0, 2 * Math.PI);
    } else halfEdges(c, view, picture.solids.molds.get(piece.mold)!, piece, where, false);
  }
  c.stroke();
  c.setLineDash([]);
}
