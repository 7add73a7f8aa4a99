// Engines, integrators and steps: changed, added, removed.
import { useState } from 'preact/hooks';

import type { EngineInfo, Lane, Session } from '../shared/live';
import type { Viewer } from './viewer';

export const mostLanes = 4; // as many as the server runs

/** A step as the server reads it: "1/240" or "0.001", above 0. */
export function goodStep(text: string): boolean {
  const match = /^\s*(\d*\.?\d+(?:e[-+]?\d+)?)\s*(?:\/\s*(\d*\.?\d+(?:e[-+]?\d+)?))?\s*$/i.exec(text);
  const value = match ? Number(match[1]) / Number(match[2] ?? 1) : NaN;
  return Number.isFinite(value) && value > 0;
}

interface Props {
  lane: Lane;
  engines: EngineInfo[];
  name: string; // for screen readers
  change: (lane: Lane) => void;
}

function LaneFields({ lane, engines, name, change }: Props) {
  const [step, setStep] = useState(lane.dt_text);
  const integrators = engines.find((engine) => engine.id === lane.engine)?.integrators ?? [];
  const bad = !goodStep(step);
  const commit = (): void => {
    if (!bad && step.trim() !== lane.dt_text) change({ ...lane, dt_text: step.trim() });
  };
  return (
    <>
      <select
        aria-label={`engine of ${name}`}
        value={lane.engine}
        onChange={(event) => change({ ...lane, engine: event.currentTarget.value, integrator: '' })}
      >
        {!engines.some((engine) => engine.id === lane.engine) && (
          <option value={lane.engine}>{lane.engine}</option>
        )}
        {engines.map((engine) => (
          <option key={engine.id} value={engine.id}>
            {engine.id} {engine.version}
          </option>
        ))}
      </select>
      <select
        aria-label={`integrator of ${name}`}
        value={lane.integrator}
        onChange={(event) => change({ ...lane, integrator: event.currentTarget.value })}
      >
        <option value="">default</option>
        {integrators.map((integrator) => (
          <option key={integrator} value={integrator}>
            {integrator}
          </option>
        ))}
      </select>
      <input
        type="text"
        class="number step"
        aria-label={`step of ${name} in seconds`}
        aria-invalid={bad}
        value={step}
        onInput={(event) => setStep(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => event.key === 'Enter' && commit()}
      />
    </>
  );
}

export function LanePanel({ viewer, session }: { viewer: Viewer; session: Session }) {
  const { lanes, engines } = session;
  const set = (next: Lane[]): void => viewer.send({ do: 'lanes', lanes: next });
  const spare = engines.find((engine) => !lanes.some((lane) => lane.engine === engine.id)) ?? engines[0];
  return (
    <section class="panel">
      <h2>Lanes</h2>
      <p class="muted">Engine, integrator and step [s]; the state is kept.</p>
      <ol class="lane-list">
        {lanes.map((lane, i) => (
          <li key={`${i} ${lane.engine} ${lane.integrator} ${lane.dt_text}`}>
            <LaneFields
              lane={lane}
              engines={engines}
              name={`lane ${i + 1}`}
              change={(changed) => set(lanes.map((old, k) => (k === i ? changed : old)))}
            />
            <button
              type="button"
              disabled={lanes.length < 2}
              aria-label={`remove lane ${i + 1}`}
              onClick={() => set(lanes.filter((_, k) => k !== i))}
            >
              ×
            </button>
          </li>
        ))}
      </ol>
      <button
        type="button"
        disabled={lanes.length >= mostLanes || !spare}
        onClick={() =>
          spare &&
          set([...lanes, { engine: spare.id, integrator: '', dt_text: lanes[0]?.dt_text ?? '1/240' }])
        }
      >
        Add a lane
      </button>
    </section>
  );
}
