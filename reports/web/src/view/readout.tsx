// The totals of every lane, in six digits.
import type { Lane } from '../shared/live';
import { Sample } from '../shared/plot_marks';
import { digits, units, valueOf } from './history';
import type { Component, Quantity, Totals } from './history';
import { laneName } from './viewer';
import type { Viewer } from './viewer';

const columns: { quantity: Quantity; component: Component; name: string }[] = [
  { quantity: 'energy', component: 'size', name: 'E' },
  ...(['momentum', 'angular momentum'] as Quantity[]).flatMap((quantity) =>
    (['size', 'x', 'y', 'z'] as Component[]).map((component) => {
      const letter = quantity === 'momentum' ? 'p' : 'L';
      return { quantity, component, name: component === 'size' ? `|${letter}|` : `${letter} ${component}` };
    }),
  ),
];

function drift(first: Totals | undefined, now: Totals): string {
  if (!first || first.energy == null || now.energy == null) return '–';
  return digits(now.energy - first.energy);
}

export function Readout({ viewer, lanes }: { viewer: Viewer; lanes: Lane[] }) {
  const states = viewer.state?.lanes ?? [];
  const first = viewer.history.first?.lanes;
  return (
    <div class="wide" tabIndex={0} role="region" aria-label="totals">
      <table class="readout">
        <thead>
          <tr>
            <th scope="col">lane</th>
            <th scope="col">contacts</th>
            <th scope="col">
              E − E₀ <span class="muted">[J]</span>
            </th>
            {columns.map(({ quantity, name }) => (
              <th scope="col" key={name}>
                {name} <span class="muted">[{units[quantity]}]</span>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {lanes.map((lane, i) => {
            const state = states[i];
            const runs = state?.status === 'running';
            return (
              <tr key={`${i} ${laneName(lane)}`}>
                <th scope="row">
                  <Sample style={i} /> {laneName(lane)}
                </th>
                <td class="number">{state && runs ? state.contacts.length : '–'}</td>
                <td class="number">{state && runs ? drift(first?.[i], state) : '–'}</td>
                {columns.map(({ quantity, component, name }) => (
                  <td class="number" key={name}>
                    {state && runs ? digits(valueOf(state, quantity, component)) : '–'}
                  </td>
                ))}
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
