// Draws a picture with WebGL 2: solids by instances, lines as strips, water last.
import {
  Camera,
  ColorManagement,
  DoubleSide,
  GLSL3,
  LinearSRGBColorSpace,
  Matrix4,
  Mesh,
  RawShaderMaterial,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { DataTexture, IUniform } from 'three';

import { Batch } from './batch';
import { fieldOfView } from './orbit';
import type { View } from './orbit';
import type { Picture } from './picture';
import * as shaders from './shaders';
import type { Stage } from './stage';
import { byMold } from './solids';
import { colourTable, Strips, TrailStrip } from './strips';
import type { Layer } from './types';
import { dot } from './vectors';
import { waterMesh } from './water_sheet';

ColorManagement.enabled = false; // colours go to the screen as the scene and the style sheet give them
const layers: Layer[] = ['bodies', 'ghost'];

type Uniforms = Record<string, IUniform>;

export class WebGLStage implements Stage {
  readonly webgl = true;
  lost = false;
  onChange: (() => void) | null = null;
  private readonly renderer: WebGLRenderer;
  private readonly camera = new Camera();
  private readonly common: Uniforms = {
    view: { value: new Matrix4() },
    projection: { value: new Matrix4() },
    pixels: { value: new Vector2(1, 1) },
    ratio: { value: 1 },
    near: { value: 0.1 },
    smallest: { value: 0 },
    ink: { value: new Vector3() },
  };
  private readonly materials = {
    body: this.material(shaders.solidVertex, shaders.solidFragment, { grow: 0 }, {}),
    ghost: this.material(
      shaders.solidVertex,
      shaders.ghostFragment,
      { grow: 0.008 },
      { transparent: true, depthWrite: false },
    ),
    edge: this.material(
      shaders.edgeVertex,
      shaders.edgeFragment,
      { grow: 0.012 },
      { transparent: true, depthWrite: false },
    ),
    line: this.material(shaders.lineVertex, shaders.lineFragment, { bias: 1e-4 }, {}),
    mark: this.material(
      shaders.lineVertex,
      shaders.lineFragment,
      { bias: 0 },
      { depthTest: false, transparent: true },
    ),
  };
  private picture: Picture | null = null;
  private scene = new Scene();
  private batches: Record<Layer, Batch[]> = { bodies: [], ghost: [] };
  private placed: Record<Layer, number> = { bodies: -1, ghost: -1 };
  private strips: Strips[] = [];
  private trails: Record<Layer, TrailStrip> | null = null;
  private waters: { mesh: Mesh; material: RawShaderMaterial }[] = [];
  private colours: DataTexture | null = null;

  constructor(
    readonly canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
  ) {
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.sortObjects = true;
    this.scene.matrixWorldAutoUpdate = false;
    this.camera.matrixWorldAutoUpdate = false;
    canvas.addEventListener('webglcontextlost', this.onLost);
    canvas.addEventListener('webglcontextrestored', this.onRestored);
  }

  private readonly onLost = (event: Event): void => {
    event.preventDefault(); // asks for the context again
    this.lost = true;
    this.clear();
    for (const material of Object.values(this.materials)) material.dispose();
    this.onChange?.();
  };

  private readonly onRestored = (): void => {
    this.lost = false;
    if (this.picture) this.show(this.picture);
    this.onChange?.();
  };

  private material(
    vertexShader: string,
    fragmentShader: string,
    own: Record<string, unknown>,
    more: object,
  ): RawShaderMaterial {
    const uniforms: Uniforms = { ...this.common };
    for (const [name, value] of Object.entries(own)) uniforms[name] = { value };
    return new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, ...more });
  }

  show(picture: Picture): void {
    this.clear();
    this.picture = picture;
    if (this.lost) return;
    const colours = picture.colours;
    const groups = byMold(picture.solids);
    for (const layer of layers) {
      const ghost = layer === 'ghost';
      const fill = ghost ? this.materials.ghost : this.materials.body;
      for (const [mold, pieces] of groups) {
        const batch = new Batch(
          picture.solids.molds.get(mold)!,
          pieces,
          colours,
          fill,
          ghost ? this.materials.edge : null,
        );
        for (const object of batch.drawn) {
          object.renderOrder = ghost ? 6 : 0;
          this.scene.add(object);
        }
        this.batches[layer].push(batch);
      }
    }
    this.placed = { bodies: -1, ghost: -1 };
    const { line, mark } = this.materials;
    this.strips = [
      new Strips(picture.fixed, line, 1),
      new Strips(picture.links, line, 2),
      new Strips(picture.marks, mark, 9),
    ];
    for (const strip of this.strips) this.scene.add(strip.drawn);
    this.colours = colourTable(colours);
    const trail = (dashes: number): TrailStrip =>
      new TrailStrip(
        this.material(
          shaders.trailVertex,
          shaders.lineFragment,
          { bias: 1e-4, bodies: 1, dashes, colors: this.colours },
          {},
        ),
      );
    this.trails = { bodies: trail(0), ghost: trail(1) };
    for (const layer of layers) this.scene.add(this.trails[layer].drawn);
    for (const water of picture.scene.water) {
      const { level, wave, speed } = water;
      const own = { level, wave, speed, time: 0, cells: water.mode === 'step', alpha: 0.55 };
      // Depth alone first: then only the nearest of several waves colours a pixel.
      for (const colorWrite of [false, true]) {
        const material = this.material(shaders.waterVertex, shaders.waterFragment, own, {
          transparent: true,
          side: DoubleSide,
          colorWrite,
        });
        const mesh = waterMesh(water, picture.bounds, material);
        mesh.renderOrder = colorWrite ? 8 : 7;
        this.waters.push({ mesh, material });
        this.scene.add(mesh);
      }
    }
  }

  private look(view: View): void {
    const { right: r, up: u, back: b, eye, near, far, width, height, ratio } = view;
    const c = this.common;
    (c.view!.value as Matrix4).set(
      r[0],
      r[1],
      r[2],
      -dot(r, eye),
      u[0],
      u[1],
      u[2],
      -dot(u, eye),
      b[0],
      b[1],
      b[2],
      -dot(b, eye),
      0,
      0,
      0,
      1,
    );
    const f = 1 / Math.tan(fieldOfView / 2);
    const depth = 1 / (near - far);
    (c.projection!.value as Matrix4).set(
      (f * height) / width,
      0,
      0,
      0,
      0,
      f,
      0,
      0,
      0,
      0,
      (near + far) * depth,
      2 * near * far * depth,
      0,
      0,
      -1,
      0,
    );
    const [w, h] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    if (this.canvas.width !== w || this.canvas.height !== h) this.renderer.setSize(w, h, false);
    (c.pixels!.value as Vector2).set(w, h);
    c.ratio!.value = ratio;
    c.near!.value = near;
    c.smallest!.value = (3 * 2) / f / height; // 3 css px
    (c.ink!.value as Vector3).set(...this.picture!.theme.ink);
  }

  draw(view: View): void {
    const picture = this.picture;
    if (!picture || this.lost) return;
    this.look(view);
    for (const layer of layers) {
      const bodies = picture.layers[layer];
      if (this.placed[layer] !== bodies.version) {
        this.placed[layer] = bodies.version;
        for (const batch of this.batches[layer]) {
          for (const object of batch.drawn) object.visible = bodies.shown;
          if (bodies.shown) batch.place(bodies.position, bodies.orientation, bodies.hidden);
        }
      }
      this.trails![layer].sync(picture.trails[layer]);
    }
    for (const strip of this.strips) strip.sync();
    for (const { material } of this.waters) material.uniforms.time!.value = picture.time;
    const [red, green, blue] = picture.theme.ground;
    this.renderer.getContext().clearColor(red, green, blue, 1);
    this.renderer.setClearColor(
      (Math.round(red * 255) << 16) | (Math.round(green * 255) << 8) | Math.round(blue * 255),
      1,
    );
    this.renderer.render(this.scene, this.camera);
  }

  private clear(): void {
    for (const layer of layers) {
      for (const batch of this.batches[layer]) batch.dispose();
      this.trails?.[layer].dispose();
      this.trails?.[layer].material.dispose();
    }
    for (const strip of this.strips) strip.dispose();
    for (const { mesh, material } of this.waters) {
      mesh.geometry.dispose();
      material.dispose();
    }
    this.colours?.dispose();
    this.batches = { bodies: [], ghost: [] };
    this.strips = [];
    this.waters = [];
    this.trails = null;
    this.scene.clear();
  }

  dispose(): void {
    this.clear();
    for (const material of Object.values(this.materials)) material.dispose();
    this.canvas.removeEventListener('webglcontextlost', this.onLost);
    this.canvas.removeEventListener('webglcontextrestored', this.onRestored);
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // browsers keep few contexts; this one is given back now
  }
}
