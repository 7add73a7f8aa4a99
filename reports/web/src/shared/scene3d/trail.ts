// Where bodies have been, as arrays that a graphics card takes without change.

export interface Trail {
  source: Float32Array; // as it was given: [frame][body][3] [m]
  positions: Float32Array; // the same, finite and with at most `most` points
  bodies: number;
  frames: number; // of `positions`
  every: number; // frames of `source` per frame of `positions`
  upTo: number; // in frames of `positions`
  version: number;
}

const most = 150000; // points

/** A body without a finite position stays where it was, which draws nothing. */
export function makeTrail(source: Float32Array, bodies: number, upTo: number, version: number): Trail {
  const given = Math.floor(source.length / (3 * bodies));
  const every = Math.max(1, Math.ceil((given * bodies) / most));
  const frames = Math.floor((given - 1) / every) + 1;
  const positions = new Float32Array(3 * bodies * frames);
  for (let frame = 0; frame < frames; ++frame)
    for (let body = 0; body < bodies; ++body) {
      const from = 3 * (frame * every * bodies + body);
      const to = 3 * (frame * bodies + body);
      const good = Number.isFinite(source[from]! + source[from + 1]! + source[from + 2]!);
      for (let i = 0; i < 3; ++i)
        positions[to + i] = good ? source[from + i]! : frame > 0 ? positions[to + i - 3 * bodies]! : NaN;
    }
  // Before its first finite position a body is where it then appears.
  for (let i = positions.length - 1; i >= 0; --i)
    if (Number.isNaN(positions[i])) positions[i] = positions[i + 3 * bodies] ?? 0;
  return { source, positions, bodies, frames, every, upTo: upTo / every, version };
}
