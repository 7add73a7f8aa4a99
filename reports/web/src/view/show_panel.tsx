// What the pictures show.
import type { Shown } from './lane_picture';
import { digits } from './history';
import type { ArrowChoice } from './poses';
import type { Viewer } from './viewer';

const choices: { name: keyof Shown; label: string; key: string; unit?: string }[] = [
  { name: 'velocity', label: 'Velocity', key: 'V', unit: 'm/s' },
  { name: 'momentum', label: 'Momentum', key: 'M', unit: 'kg m/s' },
  { name: 'angular momentum', label: 'Angular momentum', key: 'L', unit: 'kg m²/s' },
  { name: 'trails', label: 'Trails', key: 'T' },
  { name: 'contacts', label: 'Contacts, impulses', key: 'C', unit: 'N s' },
  { name: 'links', label: 'Springs, joints', key: 'J' },
];

/** What the longest arrow of a kind stands for. */
const longest = (viewer: Viewer, name: keyof Shown): number =>
  name === 'contacts' ? viewer.scale.impulse : viewer.scale.of(name as ArrowChoice);

export function ShowPanel({ viewer }: { viewer: Viewer }) {
  return (
    <section class="panel">
      <h2>Show</h2>
      <div class="choices">
        {choices.map(({ name, label, key, unit }) => (
          <label key={name}>
            <input
              type="checkbox"
              checked={viewer.shown[name]}
              onChange={(event) => viewer.show({ [name]: event.currentTarget.checked })}
            />
            {label} <kbd>{key}</kbd>
            {unit && viewer.shown[name] && (
              <span class="muted number">
                {' '}
                longest {digits(longest(viewer, name))} {unit}
              </span>
            )}
          </label>
        ))}
      </div>
    </section>
  );
}
