// Numbers of the scene that may change while it runs.
import { useState } from 'preact/hooks';

import type { Scene, Vector } from '../shared/documents';
import { parametersOf, readValue } from './parameters';
import type { Parameter } from './parameters';
import type { Viewer } from './viewer';

interface NumberProps {
  value: number;
  label: string;
  check: (text: string) => { value: number } | { error: string };
  send: (value: number) => void;
}

/** A number that is sent when it is whole: with Enter, the arrows, or when it is left. */
function NumberField({ value, label, check, send }: NumberProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const read = typed === null ? null : check(typed);
  const error = read && 'error' in read ? read.error : '';
  const commit = (): void => {
    if (read && 'value' in read && read.value !== value) send(read.value);
    if (!error) setTyped(null);
  };
  return (
    <input
      type="number"
      step="any"
      class="number"
      aria-label={label}
      aria-invalid={error !== ''}
      title={error}
      value={typed ?? String(value)}
      onInput={(event) => setTyped(event.currentTarget.value)}
      onChange={commit}
      onBlur={() => (commit(), setTyped(null))}
    />
  );
}

function Field({ viewer, parameter }: { viewer: Viewer; parameter: Parameter }) {
  const { key, value, label, unit, group } = parameter;
  const check = (text: string) => readValue(parameter, text);
  if (typeof value === 'number')
    return (
      <label class="field">
        <span>{label}</span>
        <NumberField
          value={value}
          label={`${group}: ${label}`}
          check={check}
          send={(x) => viewer.send({ do: 'set', key, value: x })}
        />
        <span class="muted">{unit}</span>
      </label>
    );
  return (
    <div class="field vector" role="group" aria-label={label}>
      {value.map((x, i) => (
        <NumberField
          key={i}
          value={x}
          label={`${label}, ${'xyz'[i]}`}
          check={check}
          send={(component) =>
            viewer.send({
              do: 'set',
              key,
              value: value.map((old, k) => (k === i ? component : old)) as Vector,
            })
          }
        />
      ))}
      <span class="muted">{unit}</span>
    </div>
  );
}

export function ParameterPanel({ viewer, scene }: { viewer: Viewer; scene: Scene }) {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parametersOf(scene)) {
    const name = /^(spring|drag|attraction|water|material)\.\d+/.exec(parameter.key)?.[0] ?? parameter.group;
    const group = groups.get(name);
    if (group) group.push(parameter);
    else groups.set(name, [parameter]);
  }
  const entries = [...groups.values()];
  return (
    <section class="panel">
      <h2>Scene</h2>
      {entries.slice(0, 60).map((group, i) => (
        <details key={`${i} ${group[0]!.group}`} open={i < 3 && group.length < 8}>
          <summary>{group[0]!.group}</summary>
          {group.slice(0, 60).map((parameter) => (
            <Field key={parameter.key} viewer={viewer} parameter={parameter} />
          ))}
          {group.length > 60 && <p class="muted">and {group.length - 60} more</p>}
        </details>
      ))}
      {entries.length > 60 && <p class="muted">and {entries.length - 60} more groups</p>}
    </section>
  );
}
