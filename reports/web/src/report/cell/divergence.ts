// Where two motions of the same bodies part visibly.
import type { Frames } from '../../shared/block';
import type { Scene3DOptions } from '../../shared/scene3d';
import { nearest } from '../../shared/plot_data';

export type Bounds = NonNullable<Scene3DOptions['bounds']>;

/** The box around all finite places of a motion; null where there is none. */
export function boundsOf(position: Float32Array): Bounds | null {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < position.length; ++i) {
    const x = position[i]!;
    if (!Number.isFinite(x)) continue;
    if (x < min[i % 3]!) min[i % 3] = x;
    if (x > max[i % 3]!) max[i % 3] = x;
  }
  if (!min.every(Number.isFinite)) return null;
  return { min: [min[0]!, min[1]!, min[2]!], max: [max[0]!, max[1]!, max[2]!] };
}

/** Diagonal [m]. */
export function extent({ min, max }: Bounds): number {
  return Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}

function joined(a: Bounds, b: Bounds): Bounds {
  const [min, max] = [a.min.map((x, i) => Math.min(x, b.min[i]!)), a.max.map((x, i) => Math.max(x, b.max[i]!))];
  return { min: [min[0]!, min[1]!, min[2]!], max: [max[0]!, max[1]!, max[2]!] };
}

/** What the cameras hold: the path of the truth where it is known at several times, else the smaller of the motions,
 * as one that flies off would leave the other a dot.  A truth that is known at one time is a place and no path: the
 * box is that of the smaller motion and the place. */
export function framed(ghost: Frames | null, sides: (Frames | null)[]): Bounds | null {
  const truth = ghost ? boundsOf(ghost.position) : null;
  if (truth && ghost!.time.length > 1) return truth;
  const all = sides
    .flatMap((frames) => (frames ? [boundsOf(frames.position)] : []))
    .filter((b): b is Bounds => b !== null);
  const motion = all.sort((a, b) => extent(a) - extent(b))[0] ?? null;
  return motion && truth ? joined(motion, truth) : (motion ?? truth);
}

export interface Parting {
  time: number; // [s]
  body: number;
  distance: number; // [m]; infinite where one of them is not finite
}

/** The place of coordinate `c` of all at a time, on the straight line between frames. */
function place(frames: Frames, width: number, c: number, time: number): number {
  const near = nearest(frames.time, time);
  const left = frames.time[near]! > time ? Math.max(0, near - 1) : near;
  const right = Math.min(frames.time.length - 1, left + 1);
  const span = frames.time[right]! - frames.time[left]!;
  const share = span > 0 ? Math.min(1, Math.max(0, (time - frames.time[left]!) / span)) : 0;
  const [x, y] = [frames.position[left * width + c]!, frames.position[right * width + c]!];
  return x + share * (y - x);
}

/** The first frame of `a` at which some body lies further than `limit` [m] from where it is in `b`. */
export function parting(a: Frames, b: Frames, limit: number): Parting | null {
  if (a.time.length === 0 || b.time.length === 0) return null;
  const width = a.position.length / a.time.length;
  if (b.position.length / b.time.length !== width) return null;
  for (let frame = 0; frame < a.time.length; ++frame) {
    const time = a.time[frame]!;
    for (let body = 0; body < width / 3; ++body) {
      const gap = [0, 1, 2].map(
        (i) => a.position[frame * width + 3 * body + i]! - place(b, width, 3 * body + i, time),
      );
      const distance = Math.hypot(...gap);
      if (Number.isFinite(distance) ? distance > limit : true)
        return { time, body, distance: Number.isFinite(distance) ? distance : Infinity };
    }
  }
  return null;
}
