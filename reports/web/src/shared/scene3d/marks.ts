// What lies over a picture: arrows, contacts, the springs by which somebody pulls.
import type { Vector } from '../documents';
import { drawCoil, makeCoil } from './coil';
import type { Picture } from './picture';
import { dashed, solid } from './segments';
import type { Colour, Segments } from './segments';
import type { Arrow, ArrowKind, ContactMark, Pull } from './types';
import { add, finite, length, scale, tangents, unit } from './vectors';

/** How kinds differ without colour: width [css px], pattern, number of heads. */
const styles: Record<ArrowKind, { width: number; pattern: number; heads: number }> = {
  velocity: { width: 2.5, pattern: solid, heads: 1 },
  momentum: { width: 4, pattern: dashed, heads: 1 },
  'angular momentum': { width: 2.5, pattern: solid, heads: 2 },
  impulse: { width: 3.5, pattern: solid, heads: 1 },
  normal: { width: 1.5, pattern: dashed, heads: 1 },
};

const pulled = makeCoil(6, 10);

/** A shaft, and heads that narrow to a point. */
export function arrow(
  into: Segments,
  at: Vector,
  along: Vector,
  colour: Colour,
  width: number,
  extent: number,
  heads = 1,
  pattern = solid,
): void {
  const l = length(along);
  if (!(l > 1e-6 * extent)) return;
  const head = Math.min(0.4 / heads, (0.035 * extent) / l); // part of the arrow
  const point = (k: number): Vector => add(at, scale(along, k));
  const wide = (3 * width + 5) * Math.min(1, l / (0.07 * extent) + 0.25); // short arrows have small heads
  into.add(at, point(1 - heads * head), colour, width, width, pattern);
  for (let i = 0; i < heads; ++i) into.add(point(1 - (i + 1) * head), point(1 - i * head), colour, wide, 0);
}

export function drawArrows(picture: Picture, arrows: Arrow[]): void {
  for (const { at, along, kind } of arrows) {
    if (!finite(at) || !finite(along)) continue;
    const { width, pattern, heads } = styles[kind];
    arrow(picture.marks, at, along, picture.theme.arrows[kind], width, picture.extent, heads, pattern);
  }
}

const hatched = 120; // contacts; with more of them each is a dot

/** A hatched disc in the plane of contact, and an arrow as long as the impulse is strong beside `largest`. */
export function drawContacts(picture: Picture, contacts: ContactMark[], largest: number): void {
  const { marks, theme, extent, typical } = picture;
  const radius = Math.min(0.016 * extent, 0.7 * typical);
  const colour = theme.arrows.impulse;
  for (const { point, normal, impulse } of contacts) {
    if (!finite(point) || !finite(normal)) continue;
    const n = unit(normal, [0, 1, 0]);
    if (contacts.length <= hatched) hatchedDisc(marks, point, n, radius, colour);
    else marks.dot(point, colour, 4);
    if (impulse === null)
      arrow(marks, point, scale(n, 3 * radius), theme.arrows.normal, 1.5, extent, 1, dashed);
    else if (Number.isFinite(impulse) && largest > 0)
      arrow(marks, point, scale(n, (0.2 * extent * impulse) / largest), colour, styles.impulse.width, extent);
  }
}

function hatchedDisc(marks: Segments, point: Vector, n: Vector, radius: number, colour: Colour): void {
  const [u, v] = tangents(n);
  const rim = (angle: number): Vector =>
    add(point, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
  for (let i = 0; i < 16; ++i) marks.add(rim((Math.PI * i) / 8), rim((Math.PI * (i + 1)) / 8), colour, 1.5);
  for (const angle of [0.4, 0.8, 1.2, 1.6, 2, 2.4, 2.8]) marks.add(rim(angle), rim(-angle), colour, 1);
}

export function drawPulls(picture: Picture, pulls: Pull[]): void {
  for (const { from, to } of pulls) {
    if (!finite(from) || !finite(to)) continue;
    drawCoil(picture.marks, pulled, from, to, 0.008 * picture.extent, picture.theme.arrows.impulse, 1.5);
    picture.marks.dot(from, picture.theme.arrows.impulse, 8);
    picture.marks.dot(to, picture.theme.arrows.impulse, 8);
  }
}
