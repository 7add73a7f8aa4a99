// The picture's element: canvas, camera, what the page shows in it, and when it is drawn anew.
import type { Scene, Vector } from '../documents';
import { readTheme } from './colours';
import { clampCamera, frame, viewOf } from './orbit';
import type { View } from './orbit';
import { Picture } from './picture';
import type { Stage } from './stage';
import { WebGLStage } from './stage_webgl';
import type { Arrow, CameraState, ContactMark, Grab, Layer, Pose, Pull, Scene3D, Scene3DOptions } from './types';

function makeStage(): Stage {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { antialias: true, alpha: false, powerPreference: 'high-performance' })!;
  return new WebGLStage(canvas, context);
}

export class LiveScene3D implements Scene3D {
  readonly element: HTMLCanvasElement;
  readonly webgl: boolean;
  onCamera: ((state: CameraState) => void) | null = null;
  onGrab: ((grab: Grab) => void) | null = null;
  onPull: ((point: Vector) => void) | null = null;
  onRelease: (() => void) | null = null;
  private readonly root = document.createElement('div');
  private readonly stage: Stage;
  private picture: Picture;
  private state: CameraState;
  private framed = false;
  private stale = true;
  private readonly resized = new ResizeObserver(() => (this.stale = true));

  constructor(host: HTMLElement, scene: Scene, private readonly options: Scene3DOptions) {
    this.root.className = 'scene3d';
    host.append(this.root);
    this.stage = makeStage();
    this.webgl = this.stage.webgl;
    this.element = this.stage.canvas;
    this.element.tabIndex = 0;
    this.element.setAttribute('role', 'application');
    this.element.setAttribute('aria-label', options.label);
    this.root.append(this.element);
    this.picture = new Picture(scene, readTheme(this.root), options.bounds);
    this.stage.show(this.picture);
    this.state = frame(this.picture.bounds, 4 / 3);
    this.resized.observe(this.root);
  }

  get camera(): CameraState {
    return this.state;
  }

  set camera(state: CameraState) {
    this.state = clampCamera(state);
    this.framed = true;
    this.stale = true;
  }

  show(layer: Layer, pose: Pose | null, time: number): void {
    this.picture.layers[layer].set(pose);
    this.picture.time = time;
    this.stale = true;
  }

  trails(_layer: Layer, _positions: Float32Array | null, _bodies: number, _upTo: number): void {}
  arrows(_list: Arrow[]): void {}
  contacts(_list: ContactMark[]): void {}
  pulls(_list: Pull[]): void {}
  links(_shown: boolean): void {}

  replaceScene(scene: Scene): void {
    this.picture = new Picture(scene, this.picture.theme, this.options.bounds);
    this.stage.show(this.picture);
    this.stale = true;
  }

  private view(): View {
    const width = Math.max(this.root.clientWidth, 1);
    const height = Math.max(this.root.clientHeight, 1);
    if (!this.framed) this.state = frame(this.picture.bounds, width / height);
    return viewOf(this.state, { width, height, ratio: Math.min(devicePixelRatio || 1, 2) }, this.picture.extent);
  }

  render(): void {
    if (!this.stale) return;
    this.stale = false;
    this.stage.draw(this.view());
  }

  png(): Promise<Blob> {
    this.stale = true;
    this.render();
    return new Promise((resolve, reject) =>
      this.element.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be kept'))), 'image/png'),
    );
  }

  dispose(): void {
    this.resized.disconnect();
    this.stage.dispose();
    this.root.remove();
  }
}
