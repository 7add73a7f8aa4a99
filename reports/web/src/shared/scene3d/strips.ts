// Lines and trails on the graphics card: one instance per segment, buffers that only grow.
import {
  BufferAttribute,
  DataTexture,
  DynamicDrawUsage,
  FloatType,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  RGBAFormat,
} from 'three';
import type { RawShaderMaterial } from 'three';

import { stride } from './segments';
import type { Colour, Segments } from './segments';
import type { Trail } from './trail';

/** Two triangles: x is the end, 0 or 1, y the side. */
function quad(): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute(
    'position',
    new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, -1, 0, 1, 1, 0, 0, 1, 0]), 3),
  );
  return geometry;
}

export class Strips {
  readonly drawn: Mesh;
  private version = -1;
  private buffer: InstancedInterleavedBuffer | null = null;

  constructor(
    private readonly lines: Segments,
    material: RawShaderMaterial,
    order: number,
  ) {
    this.drawn = new Mesh(quad(), material);
    this.drawn.frustumCulled = this.drawn.matrixAutoUpdate = false;
    this.drawn.renderOrder = order;
  }

  sync(): void {
    if (this.version === this.lines.version) return;
    this.version = this.lines.version;
    if (this.buffer?.array !== this.lines.data) this.attach();
    const geometry = this.drawn.geometry as InstancedBufferGeometry;
    geometry.instanceCount = this.lines.count;
    this.drawn.visible = this.lines.count > 0;
    this.buffer!.clearUpdateRanges();
    this.buffer!.addUpdateRange(0, this.lines.count * stride);
    this.buffer!.needsUpdate = true;
  }

  /** The array was replaced by a larger one, whose size on the card is another. */
  private attach(): void {
    const material = this.drawn.material;
    this.drawn.geometry.dispose();
    const geometry = quad();
    this.buffer = new InstancedInterleavedBuffer(this.lines.data, stride);
    this.buffer.setUsage(DynamicDrawUsage);
    const part = (name: string, size: number, at: number): void => {
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.buffer!, size, at));
    };
    part('from', 3, 0);
    part('to', 3, 3);
    part('color', 3, 6);
    part('widths', 2, 9);
    part('pattern', 1, 11);
    this.drawn.geometry = geometry;
    this.drawn.material = material;
  }

  dispose(): void {
    this.drawn.geometry.dispose();
  }
}

const row = 1024;

/** Colours of bodies as a texture that a trail looks into. */
export function colourTable(colours: Colour[]): DataTexture {
  const rows = Math.max(1, Math.ceil(colours.length / row));
  const data = new Float32Array(4 * row * rows);
  colours.forEach((c, i) => data.set([...c, 1], 4 * i));
  const table = new DataTexture(data, row, rows, RGBAFormat, FloatType);
  table.needsUpdate = true;
  return table;
}

export class TrailStrip {
  readonly drawn: Mesh;
  private trail: Trail | null = null;
  private buffer: InstancedInterleavedBuffer | null = null;
  private sent = 0; // frames on the card

  constructor(readonly material: RawShaderMaterial) {
    this.drawn = new Mesh(quad(), material);
    this.drawn.frustumCulled = this.drawn.matrixAutoUpdate = false;
    this.drawn.renderOrder = 2;
    this.drawn.visible = false;
  }

  sync(trail: Trail | null): void {
    this.drawn.visible = trail !== null && trail.upTo > 0;
    if (!trail) return;
    if (this.trail !== trail) this.attach(trail);
    if (this.sent < trail.filled) {
      const frame = 3 * trail.bodies;
      this.buffer!.clearUpdateRanges();
      this.buffer!.addUpdateRange(this.sent * frame, (trail.filled - this.sent) * frame);
      this.buffer!.needsUpdate = true;
      this.sent = trail.filled;
    }
    (this.drawn.geometry as InstancedBufferGeometry).instanceCount = trail.bodies * trail.upTo;
  }

  private attach(trail: Trail): void {
    this.trail = trail;
    this.sent = 0;
    this.drawn.geometry.dispose();
    const geometry = quad();
    this.buffer = new InstancedInterleavedBuffer(trail.positions, 3);
    this.buffer.setUsage(DynamicDrawUsage);
    geometry.setAttribute('from', new InterleavedBufferAttribute(this.buffer, 3, 0));
    const later = 3 * trail.bodies; // by a frame
    geometry.setAttribute('to', new InterleavedBufferAttribute(this.buffer, 3, later));
    this.drawn.geometry = geometry;
    this.material.uniforms.bodies!.value = trail.bodies;
  }

  dispose(): void {
    this.drawn.geometry.dispose();
  }
}
