// Where bodies have been, as arrays that a graphics card takes without change.

export interface Trail {
  source: Float32Array; // as it was given: [frame][body][3] [m]
  positions: Float32Array; // the same, finite and with at most `most` points
  bodies: number;
  frames: number; // of `positions`
  every: number; // frames of `source` per frame of `positions`
  filled: number; // frames of `positions` that stand in it
  upTo: number; // in frames of `positions`
}

const most = 150000; // points

/** `source` may be filled further later on: frames are read when `upTo` first reaches them. */
export function makeTrail(source: Float32Array, bodies: number): Trail {
  const given = Math.floor(source.length / (3 * bodies));
  const every = Math.max(1, Math.ceil((given * bodies) / most));
  const frames = Math.floor((given - 1) / every) + 1;
  return {
    source,
    positions: new Float32Array(3 * bodies * frames),
    bodies,
    frames,
    every,
    filled: 0,
    upTo: 0,
  };
}

/** Shows the frames up to `upTo` of the source.  A body without a finite position stays where it was, which
 * draws nothing; before its first finite one it is where it then appears. */
export function extend(trail: Trail, upTo: number): void {
  const { source, positions, bodies, every } = trail;
  trail.upTo = Math.max(0, Math.min(Math.floor(upTo / every), trail.frames - 1));
  for (; trail.filled <= trail.upTo; ++trail.filled) {
    const frame = trail.filled;
    for (let body = 0; body < bodies; ++body) {
      const from = 3 * (frame * every * bodies + body);
      const to = 3 * (frame * bodies + body);
      const good = Number.isFinite(source[from]! + source[from + 1]! + source[from + 2]!);
      if (good && frame > 0 && Number.isNaN(positions[to - 3 * bodies]))
        for (let past = to - 3 * bodies; past >= 0; past -= 3 * bodies)
          positions.set(source.subarray(from, from + 3), past);
      for (let i = 0; i < 3; ++i)
        positions[to + i] = good ? source[from + i]! : frame > 0 ? positions[to + i - 3 * bodies]! : NaN;
    }
  }
}
