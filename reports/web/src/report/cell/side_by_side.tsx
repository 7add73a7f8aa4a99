// This engine and another of the same scenario side by side, both with the ghost of the truth.
import { useMemo, useState } from 'preact/hooks';

import type { Frames, TraceBlock } from '../../shared/block';
import type { Scene, TraceEntry } from '../../shared/documents';
import type { TimeCursor } from '../../shared/plot_cursor';
import { go } from '../address';
import { count } from '../numbers';
import { visible } from '../visible';
import type { Bounds } from './divergence';
import { CameraLink, Pane } from './pane';

export interface Side {
  title: string;
  block: TraceBlock;
  frames: Frames;
  ghost: Frames | null; // of the truth, at this run's frames or at its own times
}

export function sideOf(title: string, block: TraceBlock): Side {
  const { motion, ghost } = block.trace;
  return { title, block, frames: block.frames(motion), ghost: ghost ? block.frames(ghost) : null };
}

/** A truth that is recorded data is known at its own times, which are fewer than the frames. */
function fewTimes({ ghost, frames }: Side): string {
  if (!ghost || ghost.time.length >= frames.time.length) return '';
  const times = count(ghost.time.length, 'time');
  return `It is known at ${times} and shown at no other. `;
}

export function entryKey(entry: TraceEntry): string {
  return [entry.engine, entry.integrator, entry.dt_text].join(' ');
}

interface SideBySideProps {
  scene: Scene;
  own: Side;
  other: Side | null;
  choices: TraceEntry[];
  chosen: string; // a key of choices; "": none
  bounds: Bounds | null;
  cursor: TimeCursor;
  trouble: string; // why the other cannot be shown
}

export function SideBySide({
  scene,
  own,
  other,
  choices,
  chosen,
  bounds,
  cursor,
  trouble,
}: SideBySideProps) {
  const [ghostShown, showGhost] = useState(true);
  const [trails, showTrails] = useState(true);
  const [linked, setLinked] = useState(true);
  const cameras = useMemo(() => new CameraLink(), []);
  cameras.linked = linked;
  const follows = own.block.trace.ghost;
  const boxes: [string, boolean, (on: boolean) => void, boolean][] = [
    ['ghost of the truth', ghostShown, showGhost, own.ghost === null],
    ['trails', trails, showTrails, false],
    ['cameras linked', linked, setLinked, other === null],
  ];
  const common = { scene, bounds, cursor, cameras, ghost: ghostShown, trails };
  return (
    <section aria-labelledby="side-heading">
      <h3 id="side-heading">Side by side</h3>
      <div class="side-tools on-screen">
        <label>
          beside it{' '}
          <select value={chosen} onChange={(event) => go({ other: event.currentTarget.value || '-' })}>
            <option value="">nothing</option>
            {choices.map((entry) => (
              <option key={entryKey(entry)} value={entryKey(entry)}>
                {visible(entryKey(entry))}
              </option>
            ))}
          </select>
        </label>
        {boxes.map(([label, on, set, disabled]) => (
          <label key={label}>
            <input type="checkbox" checked={on} disabled={disabled} onChange={() => set(!on)} /> {label}
          </label>
        ))}
      </div>
      {trouble ? <p class="note">{visible(trouble)}</p> : null}
      <div class="panes">
        <Pane key={own.title} title={own.title} motions={{ bodies: own.frames, ghost: own.ghost }} {...common} />
        {other ? (
          <Pane
            key={other.title}
            title={other.title}
            motions={{ bodies: other.frames, ghost: other.ghost }}
            {...common}
          />
        ) : null}
      </div>
      <p class="note">
        {follows
          ? `The ghost follows ${visible([follows.follows, follows.source].filter(Boolean).join(': '))}. ${fewTimes(own)}`
          : 'This scene has no truth that tells where its bodies are: there is no ghost. '}
        Shown is the stored frame nearest to the cursor; nothing is drawn between frames.
      </p>
    </section>
  );
}
