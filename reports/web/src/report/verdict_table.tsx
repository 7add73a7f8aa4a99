// Verdicts as a list, each with the way to its cell.
import { useMemo } from 'preact/hooks';

import type { Verdict } from '../shared/documents';
import { stepInWords } from '../shared/durations';
import { cellAddress, link } from './address';
import { count, withInterval, withUnit, wonInWords } from './numbers';
import { digits, isMeasured } from './status';
import { StatusMark } from './status_mark';
import { Foreign, Name } from './text';
import { useFew } from './use_few';
import { visible } from './visible';

/** The cell, with its step where that tells it from others. */
export function cellText(v: Verdict, step: boolean): string {
  return `${v.scenario} / ${v.engine}${step ? `, step ${stepInWords(v.dt_text)}` : ''}`;
}

export function CellName({ verdict: v, step }: { verdict: Verdict; step: boolean }) {
  const name = { scenario: v.scenario, engine: v.engine, integrator: v.integrator, dt: v.dt_text };
  return (
    <a href={link(cellAddress(name))}>
      <Name text={cellText(v, step)} />
    </a>
  );
}

export function measuredText(v: Verdict): string {
  if (!isMeasured(v.status))
    return v.first_bad_step === null ? '' : `not finite from step ${v.first_bad_step}`;
  const won = wonInWords(digits(v.measured, v.allowed));
  return `${withInterval(v)} of ${withUnit(v.allowed, v.unit)}, ${won}`;
}

/** Claims of one run that failed as one: a crash is the same for all of them. */
function grouped(verdicts: Verdict[]): Verdict[][] {
  const out = new Map<string, Verdict[]>();
  verdicts.forEach((v, i) => {
    const alone = isMeasured(v.status) || v.status === 'non-finite';
    const key = [
      v.scenario,
      v.engine,
      v.integrator,
      v.dt_text,
      v.status,
      v.expected,
      v.detail,
      alone ? i : '',
    ].join('\u0000');
    const group = out.get(key);
    if (group) group.push(v);
    else out.set(key, [v]);
  });
  return [...out.values()];
}

function Group({ group, step }: { group: Verdict[]; step: boolean }) {
  const v = group[0]!;
  return (
    <tr>
      <th scope="row">
        <CellName verdict={v} step={step} />
      </th>
      <td>
        {group.length > 1 ? <strong>{group.length} claims: </strong> : ''}
        {visible(group.map(({ claim }) => claim).join('; '))}
      </td>
      <td>
        <StatusMark status={v.status} />
      </td>
      <td>{v.expected}</td>
      <td class="number">{measuredText(v)}</td>
      <td>
        <Foreign text={v.detail} />
      </td>
    </tr>
  );
}

interface VerdictTableProps {
  verdicts: Verdict[]; // worst first
  stepped: Set<string>; // scenarios whose rows name their step
}

export function VerdictTable({ verdicts, stepped }: VerdictTableProps) {
  const groups = useMemo(() => grouped(verdicts), [verdicts]);
  const { list, button } = useFew(groups);
  const rows = groups.length === verdicts.length ? '' : ` in ${count(groups.length, 'row')}`;
  const caption = `${count(verdicts.length, 'verdict')}${rows}, worst first`;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={caption}>
      <table>
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">cell</th>
            <th scope="col">claim</th>
            <th scope="col">status</th>
            <th scope="col">expected</th>
            <th scope="col">measured of allowed</th>
            <th scope="col">detail</th>
          </tr>
        </thead>
        <tbody>
          {list.map((group, i) => (
            <Group key={i} group={group} step={stepped.has(group[0]!.scenario)} />
          ))}
        </tbody>
      </table>
      {button}
    </div>
  );
}
