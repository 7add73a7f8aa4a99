// Springs and joints, carried by the bodies as they move.
import type { Scene, Vector } from '../documents';
import { drawCoil, makeCoil } from './coil';
import type { Coil } from './coil';
import { mix } from './colours';
import type { Bodies, Picture } from './picture';
import { add, conjugate, length, rotate, scale, subtract, tangents, unit } from './vectors';

/** A point that a body carries, or one of the world (body -1). */
interface Carried {
  body: number;
  point: Vector; // body axes [m], or world
}

interface Spring {
  from: Carried;
  to: Carried;
  radius: number; // of the coil [m]
}

interface Joint {
  type: Scene['joint'][number]['type'];
  from: Carried;
  to: Carried;
  axis: Vector; // of a hinge, axes of `from`'s body
}

export class Links {
  private readonly springs: Spring[];
  private readonly joints: Joint[];
  private readonly coil: Coil;

  constructor(
    scene: Scene,
    private readonly extent: number,
  ) {
    const index = new Map(scene.body.map((body, i) => [body.name, i]));
    const find = (name: string | undefined): number => (name === undefined ? -1 : (index.get(name) ?? -1));
    /** Where on a body a point of the world is at t = 0. */
    const carry = (body: number, world: Vector): Carried => {
      const b = scene.body[body];
      return b
        ? { body, point: rotate(conjugate(b.orientation), subtract(world, b.position)) }
        : { body: -1, point: world };
    };
    this.springs = scene.spring.map((s) => {
      const from: Carried = { body: find(s.body), point: s.anchor };
      const to: Carried =
        s.to === undefined
          ? { body: -1, point: s.pin ?? [0, 0, 0] }
          : { body: find(s.to), point: s.to_anchor ?? [0, 0, 0] };
      return {
        from,
        to,
        radius: Math.min(0.012 * extent, s.rest_length > 0 ? 0.15 * s.rest_length : Infinity),
      };
    });
    this.joints = scene.joint.map((j) => {
      const body = find(j.body);
      const axis =
        scene.body[body] && j.axis
          ? rotate(conjugate(scene.body[body].orientation), unit(j.axis, [0, 0, 1]))
          : ([0, 0, 1] as Vector);
      if (j.type === 'distance') {
        const to: Carried =
          j.to === undefined
            ? { body: -1, point: j.point ?? [0, 0, 0] }
            : { body: find(j.to), point: [0, 0, 0] };
        return { type: j.type, from: { body, point: [0, 0, 0] }, to, axis };
      }
      const point = j.point ?? [0, 0, 0];
      return { type: j.type, from: carry(body, point), to: carry(find(j.to), point), axis };
    });
    // With many springs each gets fewer pieces.
    this.coil = this.springs.length <= 200 ? makeCoil(8, 10) : makeCoil(4, 4);
  }

  draw(picture: Picture, bodies: Bodies): void {
    const { ink, ground } = picture.theme;
    for (const { from, to, radius } of this.springs) {
      if (hidden(bodies, from) || hidden(bodies, to)) continue;
      drawCoil(
        picture.links,
        this.coil,
        at(bodies, from),
        at(bodies, to),
        radius,
        mix(ink, ground, 0.2),
        1.5,
      );
    }
    for (const joint of this.joints)
      if (!hidden(bodies, joint.from) && !hidden(bodies, joint.to)) this.joint(picture, bodies, joint);
  }

  private joint(picture: Picture, bodies: Bodies, { type, from, to, axis }: Joint): void {
    const { ink, ground } = picture.theme;
    const soft = mix(ink, ground, 0.35);
    const [a, b] = [at(bodies, from), at(bodies, to)];
    if (type === 'distance') {
      picture.links.add(a, b, soft, 3);
      picture.marks.dot(a, ink, 6);
      picture.marks.dot(b, ink, 6);
      return;
    }
    // Arms from the centres to the point, and what the joint has drifted apart.
    for (const [end, point] of [
      [from, a],
      [to, b],
    ] as const)
      if (end.body >= 0 && length(end.point) > 1e-9 * this.extent)
        picture.links.add(bodies.at(end.body), point, soft, 1.5);
    picture.marks.add(a, b, ink, 1, 1, 1);
    if (type === 'fixed') {
      this.square(picture, bodies, from, a);
      return;
    }
    if (type === 'hinge') {
      const along = scale(from.body >= 0 ? rotate(bodies.turn(from.body), axis) : axis, 0.06 * this.extent);
      picture.marks.add(subtract(a, along), add(a, along), ink, 3);
    }
    for (const p of [a, b]) {
      picture.marks.dot(p, ink, 10);
      picture.marks.dot(p, ground, 5);
    }
  }

  /** A square in the body's x-y plane, so that one sees that nothing turns in it. */
  private square({ marks, theme }: Picture, bodies: Bodies, from: Carried, centre: Vector): void {
    const half = 0.018 * this.extent;
    const normal = from.body >= 0 ? rotate(bodies.turn(from.body), [0, 0, 1]) : ([0, 0, 1] as Vector);
    const [u, v] = tangents(unit(normal, [0, 0, 1]));
    const corner = (i: number): Vector =>
      add(centre, add(scale(u, i & 1 ? half : -half), scale(v, i & 2 ? half : -half)));
    for (const [i, j] of [
      [0, 1],
      [1, 3],
      [3, 2],
      [2, 0],
      [0, 3],
      [1, 2],
    ] as const)
      marks.add(corner(i), corner(j), theme.ink, 2);
  }
}

const hidden = (bodies: Bodies, end: Carried): boolean => end.body >= 0 && bodies.hidden[end.body] === 1;

function at(bodies: Bodies, end: Carried): Vector {
  return end.body < 0 ? end.point : add(bodies.at(end.body), rotate(bodies.turn(end.body), end.point));
}
