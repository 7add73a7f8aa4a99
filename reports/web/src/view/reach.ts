// How far the bodies of all lanes have gone, for a camera that keeps them in sight until somebody takes it.
import type { Scene } from '../shared/documents';
import { sceneBounds, shapeRadius } from '../shared/scene3d/bounds';
import { drawnShape } from '../shared/scene3d/stand_in';
import type { Bounds } from '../shared/scene3d/index';
import { length, subtract } from '../shared/scene3d/vectors';

const spare = 0.15; // of the size, so that the camera moves seldom
const farthest = 6; // sizes of the scene; what flies farther, and than ten times its free flight, is let go

export class Reach {
  bounds: Bounds;
  private readonly limit: number; // from the middle [m]
  private readonly radius: number[];

  constructor(scene: Scene, duration: number) {
    this.bounds = sceneBounds(scene);
    const fastest = Math.max(0, ...scene.body.map((body) => length(body.velocity)).filter(Number.isFinite));
    const gravity = Math.max(length(scene.gravity), ...scene.body.map((body) => length(body.gravity ?? [0, 0, 0])));
    const flight = fastest * duration + (gravity * duration ** 2) / 2;
    this.limit = Math.max(farthest * length(subtract(this.bounds.max, this.bounds.min)), 10 * flight);
    this.radius = scene.body.map((body) => shapeRadius(drawnShape(body)));
  }

  /** Whether the bounds grew for a body at a position of 3 per body. */
  include(position: ArrayLike<number>): boolean {
    let grew = false;
    const size = length(subtract(this.bounds.max, this.bounds.min));
    for (let i = 0; i < 3 * this.radius.length; ++i) {
      const axis = i % 3;
      const x = position[i]!;
      const r = this.radius[(i - axis) / 3]!;
      if (
        !Number.isFinite(x) ||
        Math.abs(x - (this.bounds.min[axis]! + this.bounds.max[axis]!) / 2) > this.limit
      )
        continue;
      if (x - r >= this.bounds.min[axis]! && x + r <= this.bounds.max[axis]!) continue;
      if (!grew) this.bounds = { min: [...this.bounds.min], max: [...this.bounds.max] };
      grew = true;
      if (x - r < this.bounds.min[axis]!) this.bounds.min[axis] = x - r - spare * size;
      else this.bounds.max[axis] = x + r + spare * size;
    }
    return grew;
  }
}
