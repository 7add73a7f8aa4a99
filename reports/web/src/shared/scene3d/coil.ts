// Springs as coils that stretch: straight ends and a helix between them.
import type { Vector } from '../documents';
import type { Colour, Segments } from './segments';
import { tangents } from './vectors';

const lead = 0.1; // part of the length at either end that is straight

/** A helix about its axis: per point the part of the way, and the two coordinates across in radii. */
export interface Coil {
  along: Float64Array;
  first: Float64Array;
  second: Float64Array;
}

export function makeCoil(turns: number, perTurn: number): Coil {
  const inner = turns * perTurn;
  const n = inner + 3;
  const coil: Coil = { along: new Float64Array(n), first: new Float64Array(n), second: new Float64Array(n) };
  coil.along[n - 1] = 1;
  for (let i = 0; i <= inner; ++i) {
    const angle = (2 * Math.PI * i) / perTurn;
    coil.along[i + 1] = lead + (1 - 2 * lead) * (i / inner);
    coil.first[i + 1] = Math.cos(angle);
    coil.second[i + 1] = Math.sin(angle);
  }
  return coil;
}

/** Draws a coil from a to b; where they meet it is a ring. */
export function drawCoil(
  into: Segments,
  coil: Coil,
  a: Vector,
  b: Vector,
  radius: number,
  colour: Colour,
  width: number,
): void {
  const d: Vector = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const l = Math.hypot(d[0], d[1], d[2]);
  const [u, v] = tangents(l > 0 ? [d[0] / l, d[1] / l, d[2] / l] : [0, 1, 0]);
  let [x, y, z] = a;
  for (let i = 1; i < coil.along.length; ++i) {
    const k = coil.along[i]!;
    const p = radius * coil.first[i]!;
    const q = radius * coil.second[i]!;
    const nx = a[0] + k * d[0] + p * u[0] + q * v[0];
    const ny = a[1] + k * d[1] + p * u[1] + q * v[1];
    const nz = a[2] + k * d[2] + p * u[2] + q * v[2];
    into.put(x, y, z, nx, ny, nz, colour, width);
    [x, y, z] = [nx, ny, nz];
  }
}
