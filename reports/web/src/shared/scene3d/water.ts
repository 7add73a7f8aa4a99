// The surface of water, as docs/protocol.md has it.
import type { Scene } from '../documents';
import type { Bounds } from './types';

type Water = Scene['water'][number];

export const cells = 41; // each way
export const cellSize = 0.25; // [m]
const corner = -5; // x and z of the first cell's corner [m]

/** Which cell holds x or z [m]; beyond the table the last one goes on. */
export const cellOf = (x: number): number =>
  Math.min(Math.max(Math.trunc((x - corner) / cellSize), 0), cells - 1);

/** Height of the surface [m].  volume: level + wave sin(x - speed t).  step, with i, j the cell of x and z:
 * level + wave/2 (sin(speed t + i) + sin(i j/2)). */
export function surface(water: Water, x: number, z: number, t: number): number {
  if (water.mode !== 'step') return water.level + water.wave * Math.sin(x - water.speed * t);
  const [i, j] = [cellOf(x), cellOf(z)];
  return water.level + (water.wave / 2) * (Math.sin(water.speed * t + i) + Math.sin((i * j) / 2));
}

export interface Sheet {
  place: Float32Array; // per corner x, z [m] and the cell i, j whose height it has
  index: Uint32Array; // triangles
}

/** A flat grid over the bounds with some margin. */
export function sheetOfWater(bounds: Bounds, rows: number): Sheet {
  const place = new Float32Array(4 * (rows + 1) ** 2);
  const index = new Uint32Array(6 * rows * rows);
  const side =
    1.3 *
    Math.max(
      bounds.max[0] - bounds.min[0],
      bounds.max[2] - bounds.min[2],
      0.6 * (bounds.max[1] - bounds.min[1]),
    );
  const x0 = (bounds.min[0] + bounds.max[0] - side) / 2;
  const z0 = (bounds.min[2] + bounds.max[2] - side) / 2;
  for (let i = 0; i <= rows; ++i)
    for (let j = 0; j <= rows; ++j)
      place.set([x0 + (side * i) / rows, z0 + (side * j) / rows, 0, 0], 4 * (i * (rows + 1) + j));
  for (let i = 0; i < rows; ++i)
    for (let j = 0; j < rows; ++j) {
      const a = i * (rows + 1) + j;
      index.set([a, a + 1, a + rows + 2, a, a + rows + 2, a + rows + 1], 6 * (i * rows + j));
    }
  return { place, index };
}

/** A flat top per cell, and walls between neighbours. */
export function cellsOfWater(): Sheet {
  const quads = cells * cells + 2 * cells * (cells - 1);
  const place = new Float32Array(16 * quads);
  const index = new Uint32Array(6 * quads);
  let n = 0;
  const quad = (...corners: [number, number, number, number][]): void => {
    corners.forEach((c, k) => place.set(c, 16 * n + 4 * k));
    index.set([4 * n, 4 * n + 1, 4 * n + 2, 4 * n, 4 * n + 2, 4 * n + 3], 6 * n);
    ++n;
  };
  for (let i = 0; i < cells; ++i)
    for (let j = 0; j < cells; ++j) {
      const [x, z] = [corner + cellSize * i, corner + cellSize * j];
      const [x1, z1] = [x + cellSize, z + cellSize];
      quad([x, z, i, j], [x, z1, i, j], [x1, z1, i, j], [x1, z, i, j]);
      if (i + 1 < cells) quad([x1, z, i, j], [x1, z1, i, j], [x1, z1, i + 1, j], [x1, z, i + 1, j]);
      if (j + 1 < cells) quad([x, z1, i, j], [x1, z1, i, j], [x1, z1, i, j + 1], [x, z1, i, j + 1]);
    }
  return { place, index };
}
