// Kicks and pulls: how strong, and buttons for those who use no keys.
import type { Scene } from '../shared/documents';
import { digits } from './history';
import { kick } from './kick';
import type { Viewer } from './viewer';

const most = 9; // as many as there are digits

export function KickPanel({ viewer, scene }: { viewer: Viewer; scene: Scene }) {
  const number = (value: number, label: string, unit: string, set: (x: number) => void, least = 0.01) => (
    <label>
      {label}
      <input
        type="number"
        class="number"
        min={least}
        step="any"
        value={value}
        onChange={(event) => {
          const x = event.currentTarget.valueAsNumber;
          const valid = (x > 0 || x === least) && Number.isFinite(x);
          if (valid) set(x);
          event.currentTarget.value = String(valid ? x : value);
          viewer.changed();
        }}
      />
      {unit}
    </label>
  );
  return (
    <section class="panel">
      <h2>Kick and pull</h2>
      <div class="choices">
        {number(viewer.kickSpeed, 'Kick by', 'm/s', (x) => (viewer.kickSpeed = x))}
        {number(viewer.kickSpin, 'and spin by', 'rad/s', (x) => (viewer.kickSpin = x), 0)}
        {number(viewer.pullFrequency, 'Pull at', 'Hz', (x) => (viewer.pullFrequency = x))}
      </div>
      <ul class="kicks">
        {scene.body.slice(0, most).map((body, i) => {
          const impulse = kick(scene, i, viewer.kickSpeed);
          return (
            <li key={body.name}>
              <button
                type="button"
                disabled={!impulse}
                title="with Shift the other way"
                onClick={(event) => viewer.kick(i, event.shiftKey)}
              >
                <kbd>{i + 1}</kbd> {body.name}
              </button>
              <span class="muted number">{impulse ? `${digits(Math.hypot(...impulse))} N s` : 'locked'}</span>
            </li>
          );
        })}
      </ul>
    </section>
  );
}
