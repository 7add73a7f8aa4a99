// Numbers of the scene that may change while it runs.
import { useMemo, useState } from 'preact/hooks';

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
    <>
      <input
        type="number"
        step="any"
        class="number"
        aria-label={label}
        aria-invalid={error !== ''}
        value={typed ?? String(value)}
        onInput={(event) => setTyped(event.currentTarget.value)}
        onChange={commit}
        onBlur={() => (commit(), setTyped(null))}
      />
      {error !== '' && (
        <em class="refused" role="alert">
          {error}
        </em>
      )}
    </>
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

/** Parameters of one thing of the scene together. */
function grouped(scene: Scene): Parameter[][] {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parametersOf(scene)) {
    const [thing] = /^(spring|drag|attraction|water|material)\.\d+/.exec(parameter.key) ?? [parameter.group];
    const group = groups.get(thing);
    if (group) group.push(parameter);
    else groups.set(thing, [parameter]);
  }
  return [...groups.values()];
}

const most = 60; // groups, and rows of one: more are no help

export function ParameterPanel({ viewer, scene }: { viewer: Viewer; scene: Scene }) {
  const groups = useMemo(() => grouped(scene), [scene]);
  return (
    <section class="panel">
      <h2>Scene</h2>
      {groups.slice(0, most).map((group, i) => (
        <details key={`${i} ${group[0]!.group}`} open={i < 3 && group.length < 8}>
          <summary>{group[0]!.group}</summary>
          {group.slice(0, most).map((parameter) => (
            <Field key={parameter.key} viewer={viewer} parameter={parameter} />
          ))}
          {group.length > most && <p class="muted">and {group.length - most} more</p>}
        </details>
      ))}
      {groups.length > most && <p class="muted">and {groups.length - most} more groups</p>}
    </section>
  );
}
