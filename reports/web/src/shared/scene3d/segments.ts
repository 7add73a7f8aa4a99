// Lines of a picture: pieces with a width at either end, in an array that grows and is filled anew.
import type { Vector } from '../documents';

export type Colour = [number, number, number]; // red, green, blue, 0 … 1, as the screen has them

/** Floats per segment: ends (6), colour (3), widths [css px] (2), pattern (1). */
export const stride = 12;
export const solid = 0;
export const dashed = 1;
export const round = 2; // of a segment without length

export class Segments {
  data = new Float32Array(stride * 256);
  count = 0;
  version = 0;

  clear(): void {
    this.count = 0;
    ++this.version;
  }

  add(a: Vector, b: Vector, colour: Colour, width: number, widthAtB = width, pattern = solid): void {
    this.put(a[0], a[1], a[2], b[0], b[1], b[2], colour, width, widthAtB, pattern);
  }

  /** A round dot of a diameter [css px]. */
  dot(a: Vector, colour: Colour, diameter: number): void {
    this.add(a, a, colour, diameter, diameter, round);
  }

  put(
    ax: number,
    ay: number,
    az: number,
    bx: number,
    by: number,
    bz: number,
    colour: Colour,
    width: number,
    widthAtB = width,
    pattern = solid,
  ): void {
    if ((this.count + 1) * stride > this.data.length) {
      const larger = new Float32Array(2 * this.data.length);
      larger.set(this.data);
      this.data = larger;
    }
    const at = this.count * stride;
    const d = this.data;
    d[at] = ax;
    d[at + 1] = ay;
    d[at + 2] = az;
    d[at + 3] = bx;
    d[at + 4] = by;
    d[at + 5] = bz;
    d[at + 6] = colour[0];
    d[at + 7] = colour[1];
    d[at + 8] = colour[2];
    d[at + 9] = width;
    d[at + 10] = widthAtB;
    d[at + 11] = pattern;
    ++this.count;
  }
}
