// One 3D picture that follows the cursor.  It shows the stored frame nearest in time, never one between.
import { useEffect, useRef } from 'preact/hooks';

import type { Frames } from '../../shared/block';
import type { Scene } from '../../shared/documents';
import type { TimeCursor } from '../../shared/plot_cursor';
import { nearest } from '../../shared/plot_data';
import { onTheme } from '../../shared/theme';
import { type CameraState, createScene3D, type Scene3D } from '../../shared/scene3d';
import { visible } from '../visible';
import type { Bounds } from './divergence';
import { onPaper } from './paper';

export interface Motions {
  bodies: Frames;
  ghost: Frames | null;
}

/** Pictures whose cameras move together.  Until somebody moves one, each frames the same motion by itself. */
export class CameraLink {
  linked = true;
  private moved: CameraState | null = null;
  private readonly scenes = new Set<Scene3D>();

  join(scene: Scene3D): () => void {
    if (this.moved && this.linked) scene.camera = this.moved;
    this.scenes.add(scene);
    scene.onCamera = (state) => {
      this.moved = state;
      if (this.linked) for (const other of this.scenes) if (other !== scene) other.camera = state;
    };
    return () => void this.scenes.delete(scene);
  }
}

function pose(frames: Frames, frame: number) {
  const bodies = frames.position.length / frames.time.length / 3;
  return {
    position: frames.position.subarray(3 * bodies * frame, 3 * bodies * (frame + 1)),
    orientation: frames.orientation.subarray(4 * bodies * frame, 4 * bodies * (frame + 1)),
  };
}

/** The bodies at their frame nearest to the cursor, the ghost at that frame's very time or not at all: beside a frame
 * of another time an exact run would seem to be off. */
function showAt(scene: Scene3D, { bodies, ghost }: Motions, cursor: number, ghostShown: boolean, trails: boolean) {
  if (bodies.time.length === 0) {
    scene.show('bodies', null, cursor);
    scene.trails('bodies', null, 0, 0);
    scene.show('ghost', null, cursor);
    return;
  }
  const frame = nearest(bodies.time, cursor);
  const time = bodies.time[frame]!;
  scene.show('bodies', pose(bodies, frame), cursor);
  const count = bodies.position.length / bodies.time.length / 3;
  scene.trails('bodies', trails ? bodies.position : null, count, frame);
  const same = ghost && ghost.time.length > 0 ? nearest(ghost.time, time) : -1;
  const known = ghostShown && ghost && same >= 0 && Math.abs(ghost.time[same]! - time) <= 1e-6 * Math.abs(time);
  scene.show('ghost', known ? pose(ghost, same) : null, cursor);
}

interface PaneProps {
  title: string;
  scene: Scene;
  motions: Motions;
  bounds: Bounds | null;
  cursor: TimeCursor;
  cameras: CameraLink;
  ghost: boolean;
  trails: boolean;
}

async function save(scene: Scene3D | null, name: string): Promise<void> {
  if (!scene) return;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(await scene.png());
  link.download = `${name.replace(/[^\w.-]+/g, '_')}.png`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function Pane({ title, scene, motions, bounds, cursor, cameras, ghost, trails }: PaneProps) {
  const host = useRef<HTMLDivElement>(null);
  const picture = useRef<Scene3D | null>(null);
  const note = useRef<HTMLSpanElement>(null);
  const update = useRef<() => void>(() => {});
  update.current = () => {
    if (!picture.current) return;
    showAt(picture.current, motions, cursor.time, ghost, trails);
  };

  useEffect(() => {
    const made = createScene3D(host.current!, scene, {
      label: `3D picture of ${visible(title)}`,
      ...(bounds ? { bounds } : {}),
    });
    picture.current = made;
    if (!made.webgl && note.current)
      note.current.textContent = 'No WebGL here: drawn flat, without perspective.';
    const stops = [
      cameras.join(made),
      cursor.listen(() => update.current()),
      onTheme(() => update.current()),
      onPaper(
        host.current!,
        () => update.current(),
        () => made.render(),
      ),
    ];
    let frame = requestAnimationFrame(function draw() {
      made.render();
      frame = requestAnimationFrame(draw);
    });
    return () => {
      cancelAnimationFrame(frame);
      for (const stop of stops) stop();
      made.dispose();
      picture.current = null;
    };
  }, [scene, bounds, cursor, cameras]);
  useEffect(() => update.current());

  return (
    <figure class="pane">
      <figcaption>
        <strong>{visible(title)}</strong> <span class="note" ref={note} />{' '}
        <button type="button" class="on-screen" onClick={() => void save(picture.current, title)}>
          save as PNG
        </button>
      </figcaption>
      <div class="pane-picture" ref={host} />
    </figure>
  );
}
