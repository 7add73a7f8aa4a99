// Lets the cursor run at a multiple of real time.
import { useEffect, useState } from 'preact/hooks';

import type { TimeCursor } from '../../shared/plot_cursor';

export const speeds = [0.001, 0.01, 0.1, 0.25, 0.5, 1, 2, 5, 10, 100];

/** Real time where a motion takes seconds to a minute, else what shows it in about ten seconds. */
export function fittingSpeed(duration: number): number {
  if (duration >= 2 && duration <= 60) return 1;
  return speeds.reduce((best, s) =>
    Math.abs(Math.log((s * 10) / duration)) < Math.abs(Math.log((best * 10) / duration)) ? s : best,
  );
}

export interface Player {
  playing: boolean;
  toggle: () => void;
}

export function usePlayer(cursor: TimeCursor, speed: number): Player {
  const [playing, set] = useState(false);
  useEffect(() => {
    if (!playing) return;
    cursor.running = true;
    // Stills in place of a film for who asked for less motion [ms].
    const pause = matchMedia('(prefers-reduced-motion: reduce)').matches ? 500 : 0;
    let last = performance.now();
    let frame = requestAnimationFrame(function step(now) {
      if (now - last >= pause) {
        cursor.pin += ((now - last) / 1000) * speed;
        last = now;
      }
      if (cursor.pin >= cursor.whole[1]) set(false);
      else frame = requestAnimationFrame(step);
    });
    return () => {
      cursor.running = false;
      cancelAnimationFrame(frame);
    };
  }, [playing, cursor, speed]);
  const toggle = () => {
    if (!playing && cursor.pin >= cursor.whole[1]) cursor.pin = cursor.whole[0];
    set(!playing);
  };
  return { playing, toggle };
}
