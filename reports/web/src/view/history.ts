// The latest totals of every lane over time, for read-outs and rolling plots; memory is bounded.
import type { LaneState } from '../shared/live';

/** What of a lane's state is kept. */
export type Totals = Pick<LaneState, 'status' | 'energy' | 'momentum' | 'angular_momentum'>;

export const quantities = ['energy', 'momentum', 'angular momentum'] as const;
export type Quantity = (typeof quantities)[number];
export const units: Record<Quantity, string> = {
  energy: 'J',
  momentum: 'kg m/s',
  'angular momentum': 'kg m²/s',
};
export const components = ['size', 'x', 'y', 'z'] as const;
export type Component = (typeof components)[number];

/** A total or one of its components; null where it is not finite (JSON has no other word for that). */
export function valueOf(lane: Totals, quantity: Quantity, component: Component): number | null {
  if (lane.status !== 'running') return null;
  if (quantity === 'energy') return lane.energy;
  const v = quantity === 'momentum' ? lane.momentum : lane.angular_momentum;
  if (!Array.isArray(v) || !v.every((x) => Number.isFinite(x))) return null;
  return component === 'size' ? Math.hypot(...v) : v['xyz'.indexOf(component)]!;
}

interface Sample {
  t: number; // [s]
  lanes: Totals[];
}

export class History {
  readonly samples: Sample[] = [];
  first: Sample | null = null; // since the start or the last reset

  constructor(private readonly most = 1200) {}

  add(t: number, lanes: LaneState[]): void {
    const last = this.samples[this.samples.length - 1];
    if (last && (t < last.t || lanes.length !== last.lanes.length)) this.clear();
    if (last && t === last.t) this.samples.pop(); // changed while it stands still
    const sample = {
      t,
      lanes: lanes.map(({ status, energy, momentum, angular_momentum }) => ({
        status,
        energy,
        momentum,
        angular_momentum,
      })),
    };
    this.first ??= sample;
    this.samples.push(sample);
    if (this.samples.length > this.most) this.samples.splice(0, Math.floor(this.most / 4));
  }

  clear(): void {
    this.samples.length = 0;
    this.first = null;
  }

  times(): number[] {
    return this.samples.map((s) => s.t);
  }

  series(lane: number, quantity: Quantity, component: Component): (number | null)[] {
    return this.samples.map((s) => (s.lanes[lane] ? valueOf(s.lanes[lane], quantity, component) : null));
  }
}

/** Six digits, a word where there is no number. */
export function digits(value: number | null | undefined): string {
  if (value == null || !Number.isFinite(value)) return 'not finite';
  const size = Math.abs(value);
  return size !== 0 && (size >= 1e6 || size < 1e-4) ? value.toExponential(5) : value.toPrecision(6);
}

/** A range of values with some room; a line that lies still has some, too. */
export function roomy(least: number | null, most: number | null): [number, number] {
  if (least == null || most == null) return [-1, 1];
  const size = Math.max(Math.abs(least), Math.abs(most));
  const room = most > least ? 0.08 * (most - least) : size > 0 ? 1e-3 * size : 1;
  return [least - room, most + room];
}
