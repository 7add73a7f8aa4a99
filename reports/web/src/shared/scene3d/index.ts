// 3D pictures of scenes for both pages.
import './scene3d.css';

import type { Scene } from '../documents';
import { LiveScene3D } from './live_scene';
import type { Scene3D, Scene3DOptions } from './types';

export type * from './types';

/** A picture of the scene at t = 0 in `host`, which gives it its size.  Never throws for want of WebGL. */
export function createScene3D(host: HTMLElement, scene: Scene, options: Scene3DOptions): Scene3D {
  return new LiveScene3D(host, scene, options);
}
