// The one time cursor of a cell: slider, play, steps from frame to frame, the jump to the first divergence.
import { useLayoutEffect, useState } from 'preact/hooks';

import { nearest } from '../../shared/plot_data';
import { type TimeCursor, useCursor } from '../../shared/plot_cursor';
import { short } from '../numbers';
import { fittingSpeed, speeds, usePlayer } from './player';

/** The next or last stored frame. */
export function step(cursor: TimeCursor, frames: ArrayLike<number>, by: number): void {
  const at = nearest(frames, cursor.pin);
  const next = Math.min(frames.length - 1, Math.max(0, at + by));
  cursor.pin = frames[next] ?? cursor.pin;
}

const own = 'input, select, textarea, button, a, summary, canvas, [role="region"], [role="grid"]';

function useArrows(cursor: TimeCursor, frames: ArrayLike<number>): void {
  useLayoutEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      const by = event.key === 'ArrowLeft' ? -1 : event.key === 'ArrowRight' ? 1 : 0;
      if (by === 0 || event.altKey || event.ctrlKey || event.metaKey) return;
      if (event.target instanceof Element && event.target.closest(own)) return; // has arrows of its own
      event.preventDefault();
      step(cursor, frames, event.shiftKey ? 10 * by : by);
    };
    addEventListener('keydown', onKey);
    return () => removeEventListener('keydown', onKey);
  }, [cursor, frames]);
}

export interface Divergence {
  time: number; // [s]
  what: string; // which divergence it is
}

interface TimelineProps {
  cursor: TimeCursor;
  frames: ArrayLike<number>; // times of the stored frames [s]
  divergence?: Divergence | null; // null: there is none; absent: nothing is compared
}

function Jump({ cursor, divergence }: { cursor: TimeCursor; divergence: Divergence | null }) {
  return (
    <p class="jump">
      <button
        type="button"
        disabled={!divergence}
        onClick={() => divergence && (cursor.pin = divergence.time)}
      >
        jump to the first divergence
      </button>{' '}
      {divergence
        ? `${divergence.what}, at ${short(divergence.time, 6)} s`
        : 'no first violation is recorded, and the engines shown do not part by 1 % of the extent'}
    </p>
  );
}

export function Timeline({ cursor, frames, divergence }: TimelineProps) {
  const time = useCursor(cursor);
  const [speed, setSpeed] = useState(() => fittingSpeed(cursor.whole[1] - cursor.whole[0]));
  const { playing, toggle } = usePlayer(cursor, speed);
  useArrows(cursor, frames);
  const frame = nearest(frames, time);
  return (
    <div class="timeline on-screen" role="group" aria-label="Time cursor of all plots and pictures">
      <div class="timeline-row">
        <button type="button" onClick={toggle}>
          {playing ? 'pause' : 'play'}
        </button>
        <button type="button" onClick={() => step(cursor, frames, -1)}>
          &minus;1 frame
        </button>
        <button type="button" onClick={() => step(cursor, frames, 1)}>
          +1 frame
        </button>
        <input
          type="range"
          aria-label="time"
          min={cursor.whole[0]}
          max={cursor.whole[1]}
          step={(cursor.whole[1] - cursor.whole[0]) / 1000}
          value={time}
          aria-valuetext={`${short(time)} s`}
          onInput={(event) => (cursor.pin = Number(event.currentTarget.value))}
        />
        <output class="number">
          {short(time, 5)} s of {short(cursor.whole[1], 5)} s, frame {frame + 1} of {frames.length}
        </output>
        <label>
          speed{' '}
          <select value={speed} onChange={(event) => setSpeed(Number(event.currentTarget.value))}>
            {speeds.map((s) => (
              <option key={s} value={s}>
                {s} ×
              </option>
            ))}
          </select>
        </label>
        <button type="button" onClick={() => cursor.lookCloser()}>
          plots: closer
        </button>
        {cursor.window ? (
          <button type="button" onClick={() => (cursor.window = null)}>
            plots: whole time
          </button>
        ) : null}
      </div>
      {divergence === undefined ? null : <Jump cursor={cursor} divergence={divergence} />}
    </div>
  );
}
