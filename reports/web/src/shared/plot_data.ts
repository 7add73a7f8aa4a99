// Curves as columns over common times, and what there is to say of a curve in words.

export interface Curve {
  label: string;
  style: number; // which colour, dash and marker
  faint?: boolean; // drawn thinner: something to compare with
  time: ArrayLike<number>; // [s], ascending; a time may come twice
  value: ArrayLike<number>;
  allowed?: number | null; // a level line
  band?: { low: ArrayLike<number>; high: ArrayLike<number> } | null; // at the curve's times, shaded
  violation?: { time: number; value: number | null } | null; // first beyond it; a null value was not finite
}

export interface Extremes {
  least: number;
  leastAt: number;
  greatest: number;
  greatestAt: number;
  zeros: number; // a logarithmic axis has no place for them
  lost: number; // not finite
  lostAt: number | null; // the first of these
}

/** Null where no value is finite. */
export function extremes(curve: Curve): Extremes | null {
  const out: Extremes = {
    least: Infinity,
    leastAt: 0,
    greatest: -Infinity,
    greatestAt: 0,
    zeros: 0,
    lost: 0,
    lostAt: null,
  };
  for (let i = 0; i < curve.value.length; ++i) {
    const value = curve.value[i]!;
    const at = curve.time[i]!;
    if (!Number.isFinite(value)) {
      ++out.lost;
      out.lostAt ??= at;
      continue;
    }
    if (value === 0) ++out.zeros;
    if (value < out.least) [out.least, out.leastAt] = [value, at];
    if (value > out.greatest) [out.greatest, out.greatestAt] = [value, at];
  }
  return Number.isFinite(out.greatest) ? out : null;
}

/** Index of the sample nearest in time; -1 where there is none. */
export function nearest(time: ArrayLike<number>, at: number): number {
  if (time.length === 0) return -1;
  let low = 0;
  let high = time.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time[middle]! < at) low = middle + 1;
    else high = middle;
  }
  return low > 0 && at - time[low - 1]! <= time[low]! - at ? low - 1 : low;
}

/** The lower edge of a logarithmic axis: a decade below the least positive value or level. */
export function floorOf(curves: Curve[]): number {
  let least = Infinity;
  for (const curve of curves) {
    for (let i = 0; i < curve.value.length; ++i) {
      const value = curve.value[i]!;
      if (value > 0 && value < least) least = value;
    }
    if (curve.allowed != null && curve.allowed > 0) least = Math.min(least, curve.allowed);
  }
  return Number.isFinite(least) ? 10 ** (Math.floor(Math.log10(least)) - 1) : 1e-16;
}

export type Column = (number | null | undefined)[];

/** [times, values of each curve]: undefined where a curve has no sample, null where it is not finite.  Of
 * samples at one time the largest magnitude is kept; on a logarithmic axis what is not positive lies on
 * `floor`. */
export function aligned(curves: Curve[], floor: number | null): [number[], ...Column[]] {
  const times = new Set<number>();
  for (const curve of curves) for (let i = 0; i < curve.time.length; ++i) times.add(curve.time[i]!);
  const sorted = [...times].sort((a, b) => a - b);
  const index = new Map(sorted.map((time, i) => [time, i]));
  const columns = curves.map((curve) => {
    const column: Column = new Array<undefined>(sorted.length).fill(undefined);
    for (let i = 0; i < curve.time.length; ++i) {
      const at = index.get(curve.time[i]!)!;
      const raw = curve.value[i]!;
      const value = Number.isFinite(raw) ? (floor === null ? raw : Math.max(raw, floor)) : null;
      const known = column[at];
      if (known === undefined || (value !== null && (known === null || Math.abs(value) > Math.abs(known))))
        column[at] = value;
    }
    return column;
  });
  return [sorted, ...columns];
}
