// WebGL where there is some, else a 2D canvas.
import type { Stage } from './stage';
import { CanvasStage } from './stage_canvas';
import { WebGLStage } from './stage_webgl';

/** `?webgl=off` or `#…webgl=off` asks for the picture that machines without WebGL see. */
const refused = (): boolean => /[?&#]webgl=off\b/.test(`${location.search}${location.hash}`);

export function makeStage(): Stage {
  if (!refused()) {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl2', { antialias: true, alpha: false, powerPreference: 'high-performance' });
    if (context)
      try {
        return new WebGLStage(canvas, context);
      } catch {
        // A context that cannot be used: a canvas that has one cannot have another, so a new one is made below.
      }
  }
  return new CanvasStage(document.createElement('canvas'));
}
