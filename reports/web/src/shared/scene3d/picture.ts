// What there is to draw, whoever draws it: poses, lines, trails, water.  Counters tell what changed.
import type { Scene, Vector, Quaternion } from '../documents';
import { bodyColour } from './colours';
import type { Theme } from './colours';
import { sceneBounds } from './bounds';
import { Segments } from './segments';
import type { Colour } from './segments';
import { solidsOf } from './solids';
import type { Solids } from './solids';
import type { Bounds, Layer, Pose } from './types';
import { length, subtract } from './vectors';

/** Poses of all bodies in one layer. */
export class Bodies {
  readonly position: Float64Array;
  readonly orientation: Float64Array;
  readonly hidden: Uint8Array; // 1: no finite pose
  shown = false;
  version = 0;

  constructor(readonly count: number) {
    this.position = new Float64Array(3 * count);
    this.orientation = new Float64Array(4 * count);
    this.hidden = new Uint8Array(count);
  }

  set(pose: Pose | null): void {
    ++this.version;
    this.shown = pose !== null;
    if (!pose) return;
    for (let b = 0; b < this.count; ++b) {
      let sum = 0;
      for (let i = 3 * b; i < 3 * b + 3; ++i) sum += this.position[i] = pose.position[i] ?? NaN;
      let norm = 0;
      for (let i = 4 * b; i < 4 * b + 4; ++i) norm += (this.orientation[i] = pose.orientation[i] ?? NaN) ** 2;
      // Traces round quaternions; a picture must not shear.
      const k = 1 / Math.sqrt(norm);
      this.hidden[b] = Number.isFinite(sum) && Math.abs(sum) < 1e30 && Number.isFinite(k) ? 0 : 1;
      for (let i = 4 * b; i < 4 * b + 4; ++i) this.orientation[i]! *= k;
    }
  }

  at(body: number): Vector {
    return [this.position[3 * body]!, this.position[3 * body + 1]!, this.position[3 * body + 2]!];
  }

  turn(body: number): Quaternion {
    const o = this.orientation;
    return [o[4 * body]!, o[4 * body + 1]!, o[4 * body + 2]!, o[4 * body + 3]!];
  }
}

export interface Trail {
  positions: Float32Array; // [frame][body][3] [m]
  bodies: number;
  frames: number;
  upTo: number;
  version: number; // of positions
}

export class Picture {
  readonly bounds: Bounds;
  readonly extent: number; // diagonal of the bounds [m]
  readonly solids: Solids;
  readonly colours: Colour[];
  readonly layers: Record<Layer, Bodies>;
  readonly trails: Record<Layer, Trail | null> = { bodies: null, ghost: null };
  readonly fixed = new Segments(); // planes
  readonly links = new Segments(); // springs and joints that bodies may hide
  readonly marks = new Segments(); // on top of all: arrows, contacts, joints' points
  time = 0;

  constructor(readonly scene: Scene, public theme: Theme, given: Bounds | undefined) {
    this.bounds = given ?? sceneBounds(scene);
    this.extent = Math.max(length(subtract(this.bounds.max, this.bounds.min)), 1e-9);
    this.solids = solidsOf(scene, 0.022 * this.extent);
    this.colours = scene.body.map(bodyColour);
    this.layers = { bodies: new Bodies(scene.body.length), ghost: new Bodies(scene.body.length) };
    this.layers.bodies.set({ position: scene.body.flatMap((b) => b.position), orientation: scene.body.flatMap((b) => b.orientation) });
  }
}
