// What the pictures show.
import type { Shown } from './lane_picture';
import type { Viewer } from './viewer';
import { digits } from './history';

const choices: { name: keyof Shown; label: string; key: string; unit?: string }[] = [
  { name: 'velocity', label: 'Velocity', key: 'V', unit: 'm/s' },
  { name: 'momentum', label: 'Momentum', key: 'M', unit: 'kg m/s' },
  { name: 'angular momentum', label: 'Angular momentum', key: 'L', unit: 'kg m²/s' },
  { name: 'trails', label: 'Trails', key: 'T' },
  { name: 'contacts', label: 'Contacts, impulses', key: 'C' },
  { name: 'links', label: 'Springs, joints', key: 'J' },
];

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
                longest {digits(viewer.scale.of(name as 'velocity'))} {unit}
              </span>
            )}
          </label>
        ))}
      </div>
    </section>
  );
}
