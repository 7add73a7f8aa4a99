// All instances of one mold of one layer, in one draw call (two for a ghost: stripes and edges).
import {
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  BufferAttribute,
  LineSegments,
  Mesh,
} from 'three';
import type { RawShaderMaterial } from 'three';

import type { Colour } from './segments';
import type { Mold } from './molds';
import type { Piece } from './solids';

/** The same triangles with equal corners told once: a third of the work for round shapes. */
function shared(mold: Mold): Pick<Mold, 'position' | 'normal' | 'tone' | 'lift'> & { index: number[] } {
  const result = {
    position: [] as number[],
    normal: [] as number[],
    tone: [] as number[],
    lift: [] as number[],
    index: [] as number[],
  };
  const known = new Map<string, number>();
  for (let i = 0; i < mold.tone.length; ++i) {
    const position = mold.position.slice(3 * i, 3 * i + 3);
    const normal = mold.normal.slice(3 * i, 3 * i + 3);
    const name = `${position} ${normal} ${mold.tone[i]} ${mold.lift[i]}`;
    let at = known.get(name);
    if (at === undefined) {
      at = known.size;
      known.set(name, at);
      result.position.push(...position);
      result.normal.push(...normal);
      result.tone.push(mold.tone[i]!);
      result.lift.push(mold.lift[i]!);
    }
    result.index.push(at);
  }
  return result;
}

export class Batch {
  readonly drawn: (Mesh | LineSegments)[] = [];
  private readonly center: InstancedBufferAttribute;
  private readonly turn: InstancedBufferAttribute;

  constructor(
    mold: Mold,
    private readonly pieces: Piece[],
    colours: Colour[],
    fill: RawShaderMaterial,
    edge: RawShaderMaterial | null,
  ) {
    const n = pieces.length;
    this.center = new InstancedBufferAttribute(new Float32Array(4 * n), 4).setUsage(DynamicDrawUsage);
    this.turn = new InstancedBufferAttribute(new Float32Array(4 * n), 4).setUsage(DynamicDrawUsage);
    const size = new InstancedBufferAttribute(new Float32Array(pieces.flatMap((p) => p.size)), 4);
    const color = new InstancedBufferAttribute(new Float32Array(pieces.flatMap((p) => colours[p.body]!)), 3);
    const geometry = (position: ArrayLike<number>, lift: ArrayLike<number>): InstancedBufferGeometry => {
      const g = new InstancedBufferGeometry();
      g.instanceCount = n;
      g.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
      g.setAttribute('lift', new BufferAttribute(new Float32Array(lift), 1));
      g.setAttribute('center', this.center);
      g.setAttribute('turn', this.turn);
      g.setAttribute('size', size);
      g.setAttribute('color', color);
      return g;
    };
    const { position, normal, tone, lift, index } = shared(mold);
    const body = geometry(position, lift);
    body.setAttribute('normal', new BufferAttribute(new Float32Array(normal), 3));
    body.setAttribute('tone', new BufferAttribute(new Float32Array(tone), 1));
    body.setIndex(index);
    this.drawn.push(new Mesh(body, fill));
    if (edge && mold.edges.length > 0) {
      const ends = mold.edges.filter((_, i) => i % 4 < 3);
      this.drawn.push(
        new LineSegments(
          geometry(
            ends,
            mold.edges.filter((_, i) => i % 4 === 3),
          ),
          edge,
        ),
      );
    }
    for (const object of this.drawn) object.frustumCulled = object.matrixAutoUpdate = false;
  }

  /** Poses of all bodies; `hidden[b]`: that body is not drawn. */
  place(position: Float64Array, orientation: Float64Array, hidden: Uint8Array): void {
    const c = this.center.array;
    const t = this.turn.array;
    for (let i = 0; i < this.pieces.length; ++i) {
      const { body, position: at, orientation: own } = this.pieces[i]!;
      const o = 4 * i;
      c[o + 3] = hidden[body] ? 0 : 1;
      if (hidden[body]) continue;
      const w = orientation[4 * body]!;
      const x = orientation[4 * body + 1]!;
      const y = orientation[4 * body + 2]!;
      const z = orientation[4 * body + 3]!;
      // at + 2 u x (u x at + w at), written out so that nothing is allocated for each body and frame.
      const ax = y * at[2] - z * at[1] + w * at[0];
      const ay = z * at[0] - x * at[2] + w * at[1];
      const az = x * at[1] - y * at[0] + w * at[2];
      c[o] = position[3 * body]! + at[0] + 2 * (y * az - z * ay);
      c[o + 1] = position[3 * body + 1]! + at[1] + 2 * (z * ax - x * az);
      c[o + 2] = position[3 * body + 2]! + at[2] + 2 * (x * ay - y * ax);
      t[o] = w * own[0] - x * own[1] - y * own[2] - z * own[3];
      t[o + 1] = w * own[1] + x * own[0] + y * own[3] - z * own[2];
      t[o + 2] = w * own[2] - x * own[3] + y * own[0] + z * own[1];
      t[o + 3] = w * own[3] + x * own[2] - y * own[1] + z * own[0];
    }
    this.center.needsUpdate = this.turn.needsUpdate = true;
  }

  dispose(): void {
    for (const object of this.drawn) object.geometry.dispose();
  }
}
