// One lane of a state message as arrays that the picture takes, and the arrows of its motion.
import type { Scene, Vector } from '../shared/documents';
import type { Contact } from '../shared/live';
import type { Arrow } from '../shared/scene3d/index';
import { conjugate, rotate } from '../shared/scene3d/vectors';

export const perBody = 13; // position 3, orientation 4, velocity 3, angular velocity 3

export class LanePose {
  readonly position: Float32Array;
  readonly orientation: Float32Array;
  velocity: Float32Array;
  spin: Float32Array;

  constructor(readonly bodies: number) {
    this.position = new Float32Array(3 * bodies);
    this.orientation = new Float32Array(4 * bodies);
    this.velocity = new Float32Array(3 * bodies);
    this.spin = new Float32Array(3 * bodies);
  }

  /** Reads lane number `lane`; false where the payload has no such lane. */
  read(payload: Float32Array, lane: number): boolean {
    const start = lane * this.bodies * perBody;
    if (payload.length < start + this.bodies * perBody) return false;
    for (let b = 0; b < this.bodies; ++b) {
      const from = start + b * perBody;
      for (let i = 0; i < 3; ++i) {
        this.position[3 * b + i] = payload[from + i]!;
        this.velocity[3 * b + i] = payload[from + 7 + i]!;
        this.spin[3 * b + i] = payload[from + 10 + i]!;
      }
      for (let i = 0; i < 4; ++i) this.orientation[4 * b + i] = payload[from + 3 + i]!;
    }
    return true;
  }

  vector(of: Float32Array, body: number): Vector {
    return [of[3 * body]!, of[3 * body + 1]!, of[3 * body + 2]!];
  }

  /** L = R I Rᵀ ω about the centre of mass [kg m²/s]. */
  angularMomentum(scene: Scene, body: number): Vector {
    const o = this.orientation;
    const turn: [number, number, number, number] = [
      o[4 * body]!,
      o[4 * body + 1]!,
      o[4 * body + 2]!,
      o[4 * body + 3]!,
    ];
    const w = rotate(conjugate(turn), this.vector(this.spin, body));
    const m = scene.body[body]!.inertia;
    const row = (i: number): number => m[3 * i]! * w[0] + m[3 * i + 1]! * w[1] + m[3 * i + 2]! * w[2];
    return rotate(turn, [row(0), row(1), row(2)]);
  }
}

export type ArrowChoice = 'velocity' | 'momentum' | 'angular momentum';

/** Arrows of one scale per kind: the largest seen so far is as long as `length` [m]. */
export class ArrowScale {
  private readonly largest = new Map<ArrowChoice, number>();

  of(kind: ArrowChoice): number {
    return this.largest.get(kind) ?? 0;
  }

  /** The largest impulse of a contact in any lane [N s]. */
  impulse = 0;

  see(contacts: Contact[]): void {
    for (const { impulse } of contacts)
      if (Number.isFinite(impulse)) this.impulse = Math.max(this.impulse, impulse!);
  }

  clear(): void {
    this.largest.clear();
    this.impulse = 0;
  }

  arrows(scene: Scene, pose: LanePose, kinds: ArrowChoice[], length: number): Arrow[] {
    const list: Arrow[] = [];
    for (const kind of kinds)
      for (let body = 0; body < pose.bodies; ++body) {
        const b = scene.body[body];
        if (!b || b.locked) continue;
        const v =
          kind === 'angular momentum' ? pose.angularMomentum(scene, body) : pose.vector(pose.velocity, body);
        const k = kind === 'momentum' ? b.mass : 1;
        const size = k * Math.hypot(...v);
        if (!Number.isFinite(size) || size === 0) continue;
        if (size > this.of(kind)) this.largest.set(kind, size);
        list.push({ at: pose.vector(pose.position, body), along: [k * v[0], k * v[1], k * v[2]], kind });
      }
    for (const arrow of list) {
      const scale = length / this.of(arrow.kind as ArrowChoice);
      arrow.along = [scale * arrow.along[0], scale * arrow.along[1], scale * arrow.along[2]];
    }
    return list;
  }
}
