// The 3D picture of one lane and what it shows of a state.
import type { Scene, Vector } from '../shared/documents';
import type { LaneState, StateMessage } from '../shared/live';
import { createScene3D } from '../shared/scene3d/index';
import type { CameraState, Grab, Scene3D } from '../shared/scene3d/index';
import { sceneBounds } from '../shared/scene3d/bounds';
import { add, length, rotate, subtract } from '../shared/scene3d/vectors';
import { LanePose } from './poses';
import type { ArrowChoice, ArrowScale } from './poses';
import { TrailRecorder } from './trail_recorder';

export interface Shown {
  velocity: boolean;
  momentum: boolean;
  'angular momentum': boolean;
  trails: boolean;
  contacts: boolean;
  links: boolean;
}

export interface Hands {
  camera(state: CameraState, from: LanePicture): void;
  frameAll(): void;
  grab(grab: Grab): void;
  pull(point: Vector): void;
  release(): void;
}

export class LanePicture {
  readonly picture: Scene3D;
  private pose: LanePose;
  private trail: TrailRecorder;
  private arrowLength: number; // of the longest [m]
  private time = -Infinity;

  constructor(
    host: HTMLElement,
    private scene: Scene,
    label: string,
    hands: Hands,
  ) {
    this.picture = createScene3D(host, scene, { label });
    this.pose = new LanePose(scene.body.length);
    this.trail = new TrailRecorder(scene.body.length);
    this.arrowLength = this.reach();
    this.picture.onCamera = (state) => hands.camera(state, this);
    this.picture.onFrameAll = () => hands.frameAll();
    this.picture.onGrab = (grab) => hands.grab(grab);
    this.picture.onPull = (point) => hands.pull(point);
    this.picture.onRelease = () => hands.release();
  }

  private reach(): number {
    const { min, max } = sceneBounds(this.scene);
    return 0.25 * length(subtract(max, min));
  }

  /** `looks`: whether the scene looks another way and not only behaves so. */
  setScene(scene: Scene, looks: boolean): void {
    this.scene = scene;
    if (!looks) return;
    this.picture.replaceScene(scene);
    this.pose = new LanePose(scene.body.length);
    this.trail = new TrailRecorder(scene.body.length);
    this.arrowLength = this.reach();
    this.time = -Infinity;
  }

  /** Every state that comes, drawn or not, is a point of the trail; false where this lane has none. */
  read(t: number, payload: Float32Array, index: number): boolean {
    if (!this.pose.read(payload, index)) return false;
    if (t < this.time) this.trail.clear();
    if (t !== this.time) this.trail.add(this.pose.position);
    this.time = t;
    return true;
  }

  get position(): Float32Array {
    return this.pose.position;
  }

  /** Shows the state that was read last.  `anchors`: where on its body somebody holds it, body axes. */
  update(
    state: StateMessage,
    lane: LaneState,
    shown: Shown,
    scale: ArrowScale,
    anchors: Map<number, Vector>,
  ): void {
    const { picture, pose, scene } = this;
    if (lane.status !== 'running' || this.time === -Infinity) return;
    picture.show('bodies', pose, state.t);
    picture.links(shown.links);
    picture.trails('bodies', shown.trails ? this.trail.positions : null, pose.bodies, this.trail.frames - 1);
    const kinds = (['velocity', 'momentum', 'angular momentum'] as ArrowChoice[]).filter(
      (kind) => shown[kind],
    );
    picture.arrows(scale.arrows(scene, pose, kinds, this.arrowLength));
    picture.contacts(shown.contacts ? lane.contacts : [], scale.impulse);
    picture.pulls(
      state.pulls
        .filter((pull) => pull.body < pose.bodies)
        .map(({ body, pin }) => {
          const o = pose.orientation;
          const turn: [number, number, number, number] = [
            o[4 * body]!,
            o[4 * body + 1]!,
            o[4 * body + 2]!,
            o[4 * body + 3]!,
          ];
          return {
            from: add(pose.vector(pose.position, body), rotate(turn, anchors.get(body) ?? [0, 0, 0])),
            to: pin,
          };
        }),
    );
  }

  dispose(): void {
    this.picture.dispose();
  }
}
