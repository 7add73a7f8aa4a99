// Draws a picture without WebGL: orthographic, on a 2D canvas, far things first.
import { css, mix } from './colours';
import { projectParallel } from './orbit';
import type { View } from './orbit';
import type { Picture } from './picture';
import { outlines, pieceItems } from './flat_solids';
import type { Item } from './flat_solids';
import { stride } from './segments';
import type { Segments } from './segments';
import type { Stage } from './stage';
import type { Trail } from './trail';
import type { Layer } from './types';
import type { Vector } from '../documents';
import { surface } from './water';

const layers: Layer[] = ['bodies', 'ghost'];

export class CanvasStage implements Stage {
  readonly webgl = false;
  readonly lost = false;
  onChange: (() => void) | null = null;
  private picture: Picture | null = null;
  private readonly context: CanvasRenderingContext2D;

  constructor(readonly canvas: HTMLCanvasElement) {
    // The processor draws: there is no WebGL, so no graphics card that could draw paths faster.
    this.context = canvas.getContext('2d', { willReadFrequently: true })!;
  }

  show(picture: Picture): void {
    this.picture = picture;
  }

  draw(view: View): void {
    const picture = this.picture;
    if (!picture) return;
    const { context, canvas } = this;
    const [w, h] = [
      Math.max(1, Math.round(view.width * view.ratio)),
      Math.max(1, Math.round(view.height * view.ratio)),
    ];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
    context.fillStyle = css(picture.theme.ground);
    context.fillRect(0, 0, view.width, view.height);
    context.lineCap = context.lineJoin = 'round';
    for (let i = 0; i < picture.fixed.count; ++i) this.segment(view, picture.fixed, i);
    for (const layer of layers) this.trail(view, picture, picture.trails[layer], layer === 'ghost');
    const items: Item[] = picture.layers.bodies.shown ? pieceItems(picture, view) : [];
    const { links } = picture;
    for (let i = 0; i < links.count; ++i)
      items.push({ depth: this.depth(view, links, i), draw: () => this.segment(view, links, i) });
    this.water(items, view, picture);
    items.sort((a, b) => b.depth - a.depth);
    for (const item of items) item.draw(context);
    if (picture.layers.ghost.shown) outlines(picture, view, context);
    for (let i = 0; i < picture.marks.count; ++i) this.segment(view, picture.marks, i);
  }

  private depth(view: View, { data }: Segments, i: number): number {
    const at = i * stride;
    const p: Vector = [
      data[at]! + data[at + 3]!,
      data[at + 1]! + data[at + 4]!,
      data[at + 2]! + data[at + 5]!,
    ];
    return projectParallel(view, [p[0] / 2, p[1] / 2, p[2] / 2]).depth;
  }

  private segment(view: View, { data }: Segments, i: number): void {
    const c = this.context;
    const at = i * stride;
    const a = projectParallel(view, [data[at]!, data[at + 1]!, data[at + 2]!]);
    const b = projectParallel(view, [data[at + 3]!, data[at + 4]!, data[at + 5]!]);
    const colour = css([data[at + 6]!, data[at + 7]!, data[at + 8]!]);
    const [wide, narrow, pattern] = [data[at + 9]!, data[at + 10]!, data[at + 11]!];
    const l = Math.hypot(b.x - a.x, b.y - a.y);
    c.fillStyle = c.strokeStyle = colour;
    c.beginPath();
    if (pattern === 2) {
      c.arc(a.x, a.y, wide / 2, 0, 2 * Math.PI);
      c.fill();
    } else if (wide !== narrow) {
      const [nx, ny] = l > 0 ? [((b.y - a.y) * wide) / 2 / l, ((a.x - b.x) * wide) / 2 / l] : [0, 0];
      c.moveTo(a.x + nx, a.y + ny);
      c.lineTo(a.x - nx, a.y - ny);
      c.lineTo(b.x, b.y);
      c.fill();
    } else {
      c.setLineDash(pattern === 1 ? [5, 4] : []);
      c.lineWidth = wide;
      c.moveTo(a.x, a.y);
      c.lineTo(b.x, b.y);
      c.stroke();
      c.setLineDash([]);
    }
  }

  private trail(view: View, picture: Picture, trail: Trail | null, dashes: boolean): void {
    if (!trail) return;
    const c = this.context;
    const last = trail.upTo;
    c.lineWidth = 1.5;
    c.setLineDash(dashes ? [5, 4] : []);
    for (let body = 0; body < trail.bodies; ++body) {
      c.strokeStyle = css(picture.colours[body] ?? picture.theme.ink);
      c.beginPath();
      for (let frame = 0; frame <= last; ++frame) {
        const at = 3 * (frame * trail.bodies + body);
        const { x, y } = projectParallel(view, trail.positions.subarray(at, at + 3) as unknown as Vector);
        c.lineTo(x, y);
      }
      c.stroke();
    }
    c.setLineDash([]);
  }

  /** Lines of equal z over the surface, each at its own depth. */
  private water(items: Item[], view: View, { scene, bounds, theme, time }: Picture): void {
    const stroke = css(mix([0.1, 0.4, 0.8], theme.ink, 0.1));
    for (const water of scene.water) {
      const side = 1.3 * Math.max(bounds.max[0] - bounds.min[0], bounds.max[2] - bounds.min[2]);
      const [x0, z0] = [
        (bounds.min[0] + bounds.max[0] - side) / 2,
        (bounds.min[2] + bounds.max[2] - side) / 2,
      ];
      for (let row = 0; row <= 16; ++row) {
        const z = z0 + (side * row) / 16;
        const draw = (c: CanvasRenderingContext2D): void => {
          c.strokeStyle = stroke;
          c.lineWidth = 1;
          c.beginPath();
          for (let k = 0; k <= 120; ++k) {
            const x = x0 + (side * k) / 120;
            const p = projectParallel(view, [x, surface(water, x, z, time), z]);
            c.lineTo(p.x, p.y);
          }
          c.stroke();
        };
        items.push({ depth: projectParallel(view, [x0 + side / 2, water.level, z]).depth, draw });
      }
    }
  }

  dispose(): void {
    this.picture = null;
  }
}
