// What there is to draw, whoever draws it: poses, lines, trails, water.  Counters tell what changed.
import type { Quaternion, Scene, Vector } from '../documents';
import { sceneBounds } from './bounds';
import { bodyColour } from './colours';
import type { Theme } from './colours';
import { Links } from './links';
import { drawArrows, drawContacts, drawPulls } from './marks';
import { drawPlanes, facing, gridStep } from './planes';
import { Segments } from './segments';
import type { Colour } from './segments';
import { solidsOf } from './solids';
import type { Solids } from './solids';
import { extend, makeTrail } from './trail';
import type { Trail } from './trail';
import type { Arrow, Bounds, ContactMark, Layer, Pose, Pull } from './types';
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

export class Picture {
  readonly bounds: Bounds;
  readonly extent: number; // diagonal of the bounds [m]
  readonly typical: number; // radius of a body in the middle of their order [m]
  readonly solids: Solids;
  readonly colours: Colour[];
  readonly layers: Record<Layer, Bodies>;
  readonly trails: Record<Layer, Trail | null> = { bodies: null, ghost: null };
  readonly fixed = new Segments(); // planes
  readonly links = new Segments(); // springs and joints that bodies may hide
  readonly marks = new Segments(); // on top of all: arrows, contacts, joints' points
  time = 0;
  arrows: Arrow[] = [];
  pulls: Pull[] = [];
  linksShown = true;
  grid = 0; // between the lines of the planes [m]
  private planesFor: { theme: Theme; held: Bounds; open: boolean[] } | null = null;
  private contacts: ContactMark[] = [];
  private largestImpulse = 0; // [N s]
  private readonly joined: Links;

  constructor(
    readonly scene: Scene,
    public theme: Theme,
    given: Bounds | undefined,
  ) {
    this.bounds = sceneBounds(scene, given);
    this.extent = Math.max(length(subtract(this.bounds.max, this.bounds.min)), 1e-9);
    this.solids = solidsOf(scene, 0.035 * this.extent);
    const sizes = [...this.solids.radius].sort((a, b) => a - b);
    this.typical = sizes[sizes.length >> 1] ?? this.extent;
    this.colours = scene.body.map(bodyColour);
    this.joined = new Links(scene, this.extent);
    this.layers = { bodies: new Bodies(scene.body.length), ghost: new Bodies(scene.body.length) };
    this.layers.bodies.set({
      position: scene.body.flatMap((b) => b.position),
      orientation: scene.body.flatMap((b) => b.orientation),
    });
  }

  /** Lines that no pose moves, for the side from which the eye sees each plane, what the camera holds and the
   * colours of now. */
  setEye(eye: Vector, held: Bounds): void {
    const open = facing(this.scene, eye);
    const { theme } = this;
    const drawn = this.planesFor;
    if (drawn?.theme === theme && drawn.held === held && open.every((is, i) => is === drawn.open[i])) return;
    this.planesFor = { theme, held, open };
    this.grid = gridStep(length(subtract(held.max, held.min)));
    this.fixed.clear();
    drawPlanes(this.fixed, this.scene, held, theme, open);
  }

  /** Lines that follow the bodies or lie over them: after every change. */
  relink(): void {
    this.links.clear();
    this.marks.clear();
    const bodies = this.layers.bodies.shown ? this.layers.bodies : this.layers.ghost;
    if (this.linksShown && bodies.shown) this.joined.draw(this, bodies);
    drawContacts(this, this.contacts, this.largestImpulse);
    drawArrows(this, this.arrows);
    drawPulls(this, this.pulls);
  }

  setContacts(contacts: ContactMark[], largest: number | undefined): void {
    this.contacts = contacts;
    if (largest !== undefined) this.largestImpulse = largest;
    else
      for (const { impulse } of contacts)
        if (Number.isFinite(impulse)) this.largestImpulse = Math.max(this.largestImpulse, impulse!);
  }

  setTrail(layer: Layer, positions: Float32Array | null, bodies: number, upTo: number): void {
    const old = this.trails[layer];
    if (!positions || bodies < 1 || positions.length < 6 * bodies) {
      this.trails[layer] = null;
      return;
    }
    const trail = old?.source === positions && old.bodies === bodies ? old : makeTrail(positions, bodies);
    extend(trail, upTo);
    this.trails[layer] = trail;
  }

  /** Names of bodies that have no finite pose. */
  lost(): string[] {
    const { shown, hidden } = this.layers.bodies;
    return shown ? this.scene.body.filter((_, i) => hidden[i]).map((b) => b.name) : [];
  }
}
