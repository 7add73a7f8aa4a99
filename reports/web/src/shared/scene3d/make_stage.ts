// WebGL where there is some, else a 2D canvas.
import type { Stage } from './stage';
import { CanvasStage } from './stage_canvas';
import { WebGLStage } from './stage_webgl';

/** `?webgl=off` or `#…webgl=off` asks for the picture that machines without WebGL see. */
const refused = (): boolean => /[?&#]webgl=off\b/.test(`${location.search}${location.hash}`);

let known: boolean | null = null;

/** Whether the processor draws, for want of a graphics card: smooth edges then cost half the frames. */
function software(): boolean {
  if (known !== null) return known;
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? String(context!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  context?.getExtension('WEBGL_lose_context')?.loseContext(); // browsers keep few
  return (known = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name));
}

export function makeStage(): Stage {
  if (!refused()) {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl2', {
      antialias: !software(),
      alpha: false,
      powerPreference: 'high-performance',
    });
    if (context)
      try {
        return new WebGLStage(canvas, context);
      } catch {
        // This canvas has a context that cannot be used, and cannot have another.
      }
  }
  return new CanvasStage(document.createElement('canvas'));
}
