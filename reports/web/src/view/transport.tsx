// Play, pause, step, reset, speed and time.
import type { Session } from '../shared/live';
import type { Viewer } from './viewer';

/** A slider's place for a speed and back: decades from 0.01 to 100. */
export const slide = (speed: number): number => Math.log10(speed);
export const speedAt = (place: number): number => Number((10 ** place).toPrecision(3));

export function Transport({ viewer, session }: { viewer: Viewer; session: Session }) {
  const { state, speed, playing, connected } = viewer;
  const t = state?.t ?? 0;
  const fps = viewer.rate.perSecond;
  return (
    <section class="transport" aria-label="time">
      <button type="button" class="play" disabled={!connected} onClick={() => viewer.toggle()}>
        {playing ? 'Pause' : 'Play'}
      </button>
      <button type="button" disabled={!connected} onClick={() => viewer.send({ do: 'step' })}>
        Step
      </button>
      <button type="button" disabled={!connected} onClick={() => viewer.send({ do: 'reset' })}>
        Reset
      </button>
      <label class="speed">
        Speed
        <input
          type="range"
          min={-2}
          max={2}
          step={0.05}
          value={slide(speed)}
          aria-valuetext={`${speed} simulated seconds per second`}
          onInput={(event) => viewer.send({ do: 'speed', value: speedAt(Number(event.currentTarget.value)) })}
        />
        <output class="number">{speed.toPrecision(3)}×</output>
      </label>
      <p class="clock">
        <span class="number">t = {t.toFixed(4)} s</span>
        <span class="muted">
          {t > session.duration ? ' past the scenario’s ' : ' of '}
          {session.duration} s
        </span>
      </p>
      <p class="rate muted number" data-testid="rate">
        {fps.toFixed(0)} fps · {session.scene.body.length}{' '}
        {session.scene.body.length === 1 ? 'body' : 'bodies'}
      </p>
      {session.recording !== '' && <p class="recording">● recording to {session.recording}</p>}
    </section>
  );
}
